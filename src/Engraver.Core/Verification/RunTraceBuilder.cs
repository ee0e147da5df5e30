using System.Buffers.Binary;
using System.Security.Cryptography;
using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Keeps where a machine was while it runs. However long the run, no more than a number of places is kept: when they are too many, two neighbours become one, the one that deviates more, with the larger following error of both, so that the worst of a run is never thinned out.</summary>
/// <remarks>Not thread safe.</remarks>
public sealed class RunTraceBuilder
{
    /// <summary>About 2 MB in the file.</summary>
    public const int MostPlaces = 40_000;

    /// <summary>A span of constant speed is told by places this far apart in time, seconds.</summary>
    private const double SpanStepSeconds = 0.01;

    private const int MostStepsOfSpan = 500;

    private readonly SegmentIndex _index;
    private readonly string _drawing;
    private readonly int _most;
    private readonly List<RunTracePlace> _places = [];
    private int _together = 1;
    private int _waiting;
    private RunTracePlace _worst;

    /// <param name="drawing">What was to be cut, millimetres.</param>
    /// <param name="most">The number of places that are kept, at least 4.</param>
    public RunTraceBuilder(IReadOnlyList<Segment> drawing, int most = MostPlaces)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(most, 4);
        _drawing = DrawnFingerprint.Of(drawing);
        _index = new SegmentIndex([.. CurvePieces.Split(drawing)]);
        _most = most;
    }

    /// <summary>The machine was here.</summary>
    public void Add(in TraceSample sample)
    {
        var deviation = 0.0;
        if (sample.Cutting && _index.NearEnoughTo(sample.Place, Overlooked(sample), out var distance) >= 0) deviation = distance;
        Add(new RunTracePlace(sample.Seconds, sample.Place, sample.Cutting, deviation, sample.FollowingMm));
    }

    /// <summary>A place that deviates no more than this is not kept, however much it is: of those that become one place, another deviates more.</summary>
    private double Overlooked(in TraceSample sample) => _waiting > 0 && _worst.ToolOn == sample.Cutting ? Math.BitDecrement(_worst.DeviationMm) : -1.0;

    /// <summary>The machine went along here.</summary>
    public void Add(in TraceSpan span)
    {
        var steps = (int)Math.Clamp(Math.Ceiling((span.ToSeconds - span.FromSeconds) / SpanStepSeconds), 1.0, MostStepsOfSpan);
        for (var i = 0; i <= steps; i++) Add(span.At((double)i / steps));
    }

    /// <summary>What was kept.</summary>
    /// <param name="source">"record" or "polled".</param>
    public RunTrace ToTrace(string source) => new(source, _waiting == 0 ? [.. _places] : [.. _places, _worst]) { Drawing = _drawing };

    private void Add(in RunTracePlace place)
    {
        var following = _waiting == 0 ? place.FollowingMm : Larger(place.FollowingMm, _worst.FollowingMm);
        if (_waiting == 0 || place.DeviationMm >= _worst.DeviationMm || place.ToolOn != _worst.ToolOn) _worst = place;
        _worst = _worst with { FollowingMm = following };
        if (++_waiting < _together) return;
        _places.Add(_worst);
        _waiting = 0;
        if (_places.Count >= _most) Thin();
    }

    private void Thin()
    {
        var kept = 0;
        for (var i = 0; i + 1 < _places.Count; i += 2) _places[kept++] = Worse(_places[i], _places[i + 1]);
        if (_places.Count % 2 == 1) _places[kept++] = _places[^1];
        _places.RemoveRange(kept, _places.Count - kept);
        _together *= 2;
    }

    private static RunTracePlace Worse(in RunTracePlace one, in RunTracePlace other) => (one.DeviationMm > other.DeviationMm ? one : other) with { FollowingMm = Larger(one.FollowingMm, other.FollowingMm) };

    private static double? Larger(double? one, double? other) => one is { } known && other is { } also ? Math.Max(known, also) : one ?? other;
}

/// <summary>A short text by which the curves of a drawing are known again, wherever they are cut and however fast. Curves that are a millionth of a millimetre apart are the same.</summary>
public static class DrawnFingerprint
{
    private const double PerMillimetre = 1e6;

    /// <param name="drawing">Millimetres, in the order of the drawing.</param>
    /// <returns>16 hexadecimal digits.</returns>
    public static string Of(IReadOnlyList<Segment> drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        Span<byte> bytes = stackalloc byte[7 * sizeof(long)];
        foreach (var segment in drawing)
        {
            var middle = segment.PointAt(0.5);
            double[] numbers = [segment.Start.X, segment.Start.Y, middle.X, middle.Y, segment.End.X, segment.End.Y];
            for (var i = 0; i < numbers.Length; i++) BinaryPrimitives.WriteInt64LittleEndian(bytes[(i * sizeof(long))..], (long)Math.Round(numbers[i] * PerMillimetre));
            BinaryPrimitives.WriteInt64LittleEndian(bytes[(numbers.Length * sizeof(long))..], (long)segment.Kind);
            hash.AppendData(bytes);
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset().AsSpan(0, 8));
    }
}
