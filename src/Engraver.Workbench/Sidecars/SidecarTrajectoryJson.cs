using System.Text.Json;
using System.Text.Json.Serialization;

namespace Engraver.Workbench.Sidecars;

internal sealed class SidecarTrajectoryJson
{
    public string? Name { get; set; }

    public bool Closed { get; set; }

    public double Z { get; set; }

    public double MaxError { get; set; }

    public double? SegmentLength { get; set; }

    public List<string>? Handles { get; set; }

    public TrajectoryOriginJson? Made { get; set; }

    /// <summary>Informative; recomputed from the points when the file is read.</summary>
    public double? VerifiedBound { get; set; }

    public double? Length { get; set; }

    /// <summary>x, y or x, y, z: phantom, points visited, phantom.</summary>
    public double[][]? Lines { get; set; }

    public double[]? Knots { get; set; }

    public SegmentJson[]? Source { get; set; }

    [JsonExtensionData]
    public Dictionary<string, JsonElement>? Others { get; set; }
}
