using System.Text.Json;
using Engraver.Core.Trajectories;

namespace Engraver.Workbench.Sidecars;

/// <summary>A trajectory with its name and parameters.</summary>
/// <param name="Name">Name, also of its file without extension: letters, digits, <c>_</c>, <c>-</c> and <c>.</c></param>
/// <param name="Curve">Points and bound.</param>
/// <param name="MaxErrorMm">The requested maximum error.</param>
public sealed record DocumentTrajectory(string Name, Trajectory Curve, double MaxErrorMm)
{
    /// <summary>Length of equal steps, millimetres; null for the dynamic density.</summary>
    public double? SegmentLengthMm { get; init; }

    /// <summary>Handles of its source entities; empty if they have none.</summary>
    public IReadOnlyList<string> Handles { get; init; } = [];

    /// <summary>Its origin; null for a helix, and if the file does not define it.</summary>
    public TrajectoryOrigin? Origin { get; init; }

    /// <summary>Unknown members of its entry in the file.</summary>
    public IReadOnlyList<KeyValuePair<string, JsonElement>> Others { get; init; } = [];

    /// <summary>True for a helix, which is not a contour of the drawing.</summary>
    public bool IsHelix => Curve.Heights is not null;

    /// <summary>True for a valid file name on every system.</summary>
    public static bool IsName(string name) => name.Length is > 0 and <= 100 && name[0] != '.' && name.All(letter => char.IsAsciiLetterOrDigit(letter) || letter is '_' or '-' or '.');
}
