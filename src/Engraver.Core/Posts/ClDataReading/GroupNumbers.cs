using System.Globalization;

namespace Engraver.Core.Posts.ClDataReading;

/// <summary>The numbers of one entity by group code. A number that cannot be read is NaN, and its group code is recorded, so that a reader checks once after
/// it has read all numbers.</summary>
internal sealed class GroupNumbers(IReadOnlyList<(int Code, string Value)> pairs)
{
    /// <summary>A number of this size is not a coordinate of a drawing.</summary>
    private const double Limit = 1e12;

    /// <summary>Group code of the first number that is missing, duplicate or invalid; null while all are valid.</summary>
    public int? Invalid { get; private set; }

    /// <summary>Records that the number of a group cannot be used; the first one is kept.</summary>
    public void Reject(int code) => Invalid ??= code;

    /// <summary>The number of a group that must be there exactly once.</summary>
    public double Single(int code)
    {
        if (All(code) is [var value]) return value;
        Reject(code);
        return double.NaN;
    }

    /// <summary>The first number of a group, or a default when there is none.</summary>
    public double Optional(int code, double otherwise) => All(code) is { Length: > 0 } values ? values[0] : otherwise;

    public double[] All(int code) => [.. pairs.Where(pair => pair.Code == code).Select(Parse)];

    /// <summary>True when a number of these groups is not 0.</summary>
    public bool IsAnySet(params ReadOnlySpan<int> codes)
    {
        foreach (var pair in pairs)
        {
            if (codes.Contains(pair.Code) && Parse(pair) != 0.0) return true;
        }

        return false;
    }

    private double Parse((int Code, string Value) pair)
    {
        if (double.TryParse(pair.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && Math.Abs(value) < Limit) return value;
        Reject(pair.Code);
        return double.NaN;
    }
}
