using System.Text.Json;
using Engraver.Core.Trajectories;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Sidecars;

/// <summary>The trajectories of a document, and how the next ones are made. Immutable.</summary>
public sealed record TrajectoryList
{
    public static TrajectoryList Empty { get; } = new();

    /// <summary>In the order in which they are exported; every name once.</summary>
    public IReadOnlyList<DocumentTrajectory> All { get; init; } = [];

    public TrajectorySettings Settings { get; init; } = new();

    /// <summary>The number in the name of the next one. It never goes back, so that a name is not given twice.</summary>
    public int NextNumber { get; init; }

    /// <summary>Place of a name, any case; -1 for none.</summary>
    public int IndexOf(string name)
    {
        for (var i = 0; i < All.Count; i++)
        {
            if (All[i].Name.Equals(name, StringComparison.OrdinalIgnoreCase)) return i;
        }

        return -1;
    }
}

/// <summary>A trajectory with its name and how it was made.</summary>
/// <param name="Name">Also that of its file, without ending; letters, digits, <c>_</c>, <c>-</c> and <c>.</c></param>
/// <param name="Curve">Points and bound.</param>
/// <param name="MaxErrorMm">That was asked for.</param>
public sealed record DocumentTrajectory(string Name, Trajectory Curve, double MaxErrorMm)
{
    /// <summary>Length of equal steps, millimetres; null for the dynamic density.</summary>
    public double? SegmentLengthMm { get; init; }

    /// <summary>Handles of the entities from which it was made; empty where they have none.</summary>
    public IReadOnlyList<string> Handles { get; init; } = [];

    /// <summary>From what it was made; null for a helix, and for one of a file that does not say.</summary>
    public TrajectoryOrigin? Origin { get; init; }

    /// <summary>Members of its entry in the file that this program does not know.</summary>
    public IReadOnlyList<KeyValuePair<string, JsonElement>> Others { get; init; } = [];

    /// <summary>A helix, which is no contour of the drawing.</summary>
    public bool IsHelix => Curve.Heights is not null;

    /// <summary>True for a name that may be a file's on every system.</summary>
    public static bool IsName(string name) => name.Length is > 0 and <= 100 && name[0] != '.' && name.All(letter => char.IsAsciiLetterOrDigit(letter) || letter is '_' or '-' or '.');
}

/// <summary>How trajectories are made (the settings of the SACE commands). Lengths in millimetres.</summary>
public sealed record TrajectorySettings
{
    public static TrajectorySettings Default { get; } = new();

    /// <summary>As for jobs until the operator changes it.</summary>
    public double MaxErrorMm { get; init; } = DrawingSettings.Default.MaxErrorMm;

    /// <summary>Points as the curvature needs them; false: equal steps of <see cref="SegmentLengthMm"/>.</summary>
    public bool DynamicDensity { get; init; } = true;

    /// <summary>Until the operator changes it, the step length of SACETraj.</summary>
    public double SegmentLengthMm { get; init; } = 0.5;

    /// <summary>Height of the machining plane.</summary>
    public double PlaneZ { get; init; }

    public CornerMode Corners { get; init; }

    public TrajectoryOptions ToOptions() => new(MaxErrorMm) { SegmentLength = DynamicDensity ? null : SegmentLengthMm, Corners = Corners, Z = PlaneZ };
}
