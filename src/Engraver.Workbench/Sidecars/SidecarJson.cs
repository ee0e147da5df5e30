using System.Text.Json;
using System.Text.Json.Serialization;

namespace Engraver.Workbench.Sidecars;

/// <summary>The JSON of the file; docs/sidecar.md. Lengths in millimetres of the drawing.</summary>
internal sealed class SidecarJson
{
    public string? Version { get; set; }

    public DrawingJson? Drawing { get; set; }

    public TrajectorySettingsJson? TrajectorySettings { get; set; }

    public List<SidecarTrajectoryJson>? Trajectories { get; set; }

    public JsonElement? Operations { get; set; }

    [JsonExtensionData]
    public Dictionary<string, JsonElement>? Others { get; set; }
}

/// <param name="Fingerprint">Fingerprint of the curves (millimetres, rounded to 1e-6).</param>
internal sealed record DrawingJson(string? File, string? Fingerprint);

internal sealed record TrajectorySettingsJson(double? MaxError, bool? DynamicDensity, double? SegmentLength, double? PlaneZ, string? Corners, int? NextNumber);

/// <param name="Drawn">Fingerprint of the entities.</param>
/// <param name="Side">Only with an offset.</param>
internal sealed record TrajectoryOriginJson(int Group, int Index, int Count, string? Drawn, double? Offset, string? Side, string? Corners);

/// <summary>A segment; exactly one member is set.</summary>
internal sealed class SegmentJson
{
    /// <summary>x, y of both ends.</summary>
    public double[]? Line { get; set; }

    /// <summary>Centre x, y, radius, start angle, signed sweep (degrees), then x, y of both ends.</summary>
    public double[]? Arc { get; set; }

    /// <summary>For each span the homogeneous control points, xw, yw, zw, w in sequence.</summary>
    public double[][]? Ellipse { get; set; }

    public double[][]? Spline { get; set; }
}

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull, MaxDepth = 64)]
[JsonSerializable(typeof(SidecarJson))]
internal sealed partial class SidecarJsonContext : JsonSerializerContext;
