using System.Text.Json;
using Engraver.Core.Trajectories;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Sidecars;

/// <summary>The trajectories of a document, and the settings of the next ones. Immutable.</summary>
public sealed record TrajectoryList
{
    public static TrajectoryList Empty { get; } = new();

    /// <summary>In the order in which they are exported; with unique names.</summary>
    public IReadOnlyList<DocumentTrajectory> All { get; init; } = [];

    public TrajectorySettings Settings { get; init; } = new();

    /// <summary>The number in the name of the next trajectory. It only increases, so that names are not reused.</summary>
    public int NextNumber { get; init; }

    /// <summary>Index of a name, case-insensitive; -1 for none.</summary>
    public int IndexOf(string name)
    {
        for (var i = 0; i < All.Count; i++)
        {
            if (All[i].Name.Equals(name, StringComparison.OrdinalIgnoreCase)) return i;
        }

        return -1;
    }
}

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

/// <summary>Parameters of new trajectories (the settings of the SACE commands). Lengths in millimetres.</summary>
public sealed record TrajectorySettings
{
    public static TrajectorySettings Default { get; } = new();

    /// <summary>As for jobs until the operator changes it.</summary>
    public double MaxErrorMm { get; init; } = DrawingSettings.Default.MaxErrorMm;

    /// <summary>True: points depend on the curvature; false: equal steps of <see cref="SegmentLengthMm"/>.</summary>
    public bool DynamicDensity { get; init; } = true;

    /// <summary>Until the operator changes it, the step length of SACETraj.</summary>
    public double SegmentLengthMm { get; init; } = 0.5;

    /// <summary>Height of the machining plane.</summary>
    public double PlaneZ { get; init; }

    public CornerMode Corners { get; init; }

    public TrajectoryOptions ToOptions() => new(MaxErrorMm) { SegmentLength = DynamicDensity ? null : SegmentLengthMm, Corners = Corners, Z = PlaneZ };
}
