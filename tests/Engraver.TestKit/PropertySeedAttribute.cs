using System.Globalization;
using System.Text.RegularExpressions;
using FsCheck.Xunit;

namespace Engraver.TestKit;

/// <summary>The seed of all properties of a test project: the same in every run for a commit, so that a commit fails because of its change and not by
/// chance; a new one in the full run, which therefore finds new cases; that of <see cref="TestExtent.Replay"/> to repeat a failure.</summary>
/// <remarks>tests/Directory.Build.props applies it to every test project. A failed property states its seed, and that of its last case.</remarks>
[AttributeUsage(AttributeTargets.Assembly)]
public sealed partial class PropertySeedAttribute : PropertiesAttribute
{
    /// <summary>State and increment of the generator. FsCheck accepts odd increments only.</summary>
    public const string OfCommit = "(20261127,11400714819323198485)";

    public PropertySeedAttribute() => Replay = SeedOf(TestExtent.Replay, TestExtent.IsFull);

    /// <summary>An empty text is a new seed for each property.</summary>
    /// <exception cref="FormatException">The text is not a seed.</exception>
    public static string SeedOf(string replay, bool full)
    {
        if (replay.Length == 0) return full ? "" : OfCommit;
        if (Seed().Match(replay) is { Success: true } seed && IsNumber(seed.Groups[1]) && IsNumber(seed.Groups[2])) return replay;
        throw new FormatException($"ENGRAVER_REPLAY is '{replay}'. A seed is (state,increment) or (state,increment,size); the increment is odd.");
    }

    private static bool IsNumber(Group digits) => ulong.TryParse(digits.ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture, out _);

    [GeneratedRegex(@"^\((\d+),(\d*[13579])(,\d{1,9})?\)$")]
    private static partial Regex Seed();
}
