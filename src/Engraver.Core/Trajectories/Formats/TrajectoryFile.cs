using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories.Formats;

/// <summary>One trajectory as the text of a file, with the known properties of its execution. Lengths in millimetres.</summary>
/// <param name="Text">Text with the line ends of its format.</param>
/// <param name="Start">Required machine position at the start of the file, drawing coordinates; the XPS formats count from there.</param>
/// <param name="Points">Number of visited points, including both ends.</param>
/// <param name="SampledError">Largest distance of the path in the text from the source at dense samples.</param>
/// <param name="VerifiedBound">Proven bound: no point of the executed path is farther from the source, and no point of the source is farther from the
/// path.</param>
/// <param name="SpacingRatio">Largest ratio of neighbouring steps; 1 when the ratio is not limited.</param>
public sealed record TrajectoryFile(
    string Text, Point2D Start, double Z, int Points, double SampledError, double VerifiedBound, double SpacingRatio, double Length, bool Closed, IReadOnlyList<Segment> Source)
{
    /// <summary>Properties that the controller does not accept, each in a few words; empty when it accepts the file.</summary>
    public IReadOnlyList<string> BrokenLimits { get; init; } = [];

    /// <summary>The largest speed along the path, mm/s, at which no axis exceeds its acceleration; null when the file contains the speeds, or when it is
    /// unknown.</summary>
    public double? MaxSpeed { get; init; }

    /// <summary>A number of a file: invariant, without exponent, with the precision of the points.</summary>
    internal static string Number(double value) => NumberText.Rounded(Math.Round(value, SplineFit.Decimals) + 0.0, SplineFit.Decimals);

    /// <summary>The number with at least six decimals, as in the manuals.</summary>
    internal static string LongNumber(double value) => (Math.Round(value, SplineFit.Decimals) + 0.0).ToString("0.000000###", CultureInfo.InvariantCulture);
}
