using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using Engraver.Core.Operations;
using Engraver.Core.Trajectories;

namespace Engraver.Workbench.Sidecars;

/// <summary>The text of a sidecar file (docs/sidecar.md): deterministic when written, read completely or not at all.</summary>
public static class SidecarText
{
    /// <summary>Files of another major version are not read.</summary>
    public const int Major = 1;

    /// <summary>A higher minor version only adds members, which are preserved.</summary>
    public const int Minor = 2;

    internal const string OperationsMember = "operations";

    /// <param name="drawing">Name of the drawing's file.</param>
    /// <param name="fingerprint">Fingerprint of its curves.</param>
    public static string Write(Sidecar sidecar, string drawing, string fingerprint)
    {
        ArgumentNullException.ThrowIfNull(sidecar);
        var settings = sidecar.Trajectories.Settings;
        var json = new SidecarJson
        {
            Version = string.Create(CultureInfo.InvariantCulture, $"{Major}.{Math.Max(Minor, sidecar.Minor)}"),
            Drawing = new DrawingJson(drawing, fingerprint),
            TrajectorySettings = new TrajectorySettingsJson(settings.MaxErrorMm, settings.DynamicDensity, settings.SegmentLengthMm, settings.PlaneZ, CornersWord(settings.Corners), sidecar.Trajectories.NextNumber),
            Trajectories = [.. sidecar.Trajectories.All.Select(TrajectoryEntry.ToJson)],
            Operations = sidecar.Operations is { } plan ? Element(plan.ToFileText()) : null,
            Others = new Dictionary<string, JsonElement>(sidecar.UnknownMembers),
        };
        using var memory = new MemoryStream();
        using (var writer = new Utf8JsonWriter(memory, new JsonWriterOptions { Indented = false, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
        {
            JsonSerializer.Serialize(writer, json, SidecarJsonContext.Default.SidecarJson);
        }

        return Encoding.UTF8.GetString(memory.GetBuffer(), 0, (int)memory.Length) + "\n";
    }

    /// <summary>Reads the text.</summary>
    /// <exception cref="SidecarVersionException">It has another version.</exception>
    /// <exception cref="JsonException">It is damaged: the message says where.</exception>
    public static (Sidecar Sidecar, string? Fingerprint) Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var minor = MinorOf(text);
        var json = JsonSerializer.Deserialize(text, SidecarJsonContext.Default.SidecarJson)!;
        List<DocumentTrajectory> all = [.. (json.Trajectories ?? []).Select((one, index) => TrajectoryEntry.FromJson(one ?? throw InvalidFile($"trajectories[{index}]"), $"trajectories[{index}]"))];
        if (all.GroupBy(one => one.Name, StringComparer.OrdinalIgnoreCase).FirstOrDefault(same => same.Count() > 1) is { } twice) throw InvalidFile(Wording.Get("Sidecar.NameTwice", twice.Key));
        var list = new TrajectoryList { All = all, Settings = SettingsOf(json.TrajectorySettings), NextNumber = json.TrajectorySettings?.NextNumber ?? all.Count };
        if (list.NextNumber < 0) throw InvalidFile("trajectorySettings.nextNumber");
        var sidecar = new Sidecar { Trajectories = list, UnknownMembers = [.. json.Others ?? []], Minor = minor };
        return (json.Operations is { } operations ? WithOperations(sidecar, operations) : sidecar, json.Drawing?.Fingerprint);
    }

    /// <summary>Operations that a later version has written, or that are damaged, are kept as they are.</summary>
    private static Sidecar WithOperations(Sidecar sidecar, JsonElement operations)
    {
        var read = OperationFile.Read(operations.GetRawText(), name => (null, name));
        return read.Plan is { } plan
            ? sidecar with { Operations = plan }
            : sidecar with { UnknownMembers = [.. sidecar.UnknownMembers, new(OperationsMember, operations.Clone())], WhyNotRun = read.Diagnostics[0].Sentence };
    }

    private static JsonElement Element(string text)
    {
        using var json = JsonDocument.Parse(text);
        return json.RootElement.Clone();
    }

    internal static JsonException InvalidFile(string what) => new(Wording.Get("Sidecar.Invalid", what));

    private static TrajectorySettings SettingsOf(TrajectorySettingsJson? json)
    {
        var standard = TrajectorySettings.Default;
        if (json is null) return standard;
        var settings = new TrajectorySettings
        {
            MaxErrorMm = json.MaxError ?? standard.MaxErrorMm,
            DynamicDensity = json.DynamicDensity ?? standard.DynamicDensity,
            SegmentLengthMm = json.SegmentLength ?? standard.SegmentLengthMm,
            PlaneZ = json.PlaneZ ?? standard.PlaneZ,
            Corners = CornersOf(json.Corners, "trajectorySettings.corners"),
        };
        return settings is { MaxErrorMm: > 0.0, SegmentLengthMm: > 0.0 } ? settings : throw InvalidFile("trajectorySettings");
    }

    private static int MinorOf(string text)
    {
        using var json = JsonDocument.Parse(text);
        if (json.RootElement.ValueKind != JsonValueKind.Object || !json.RootElement.TryGetProperty("version", out var version) || version.ValueKind != JsonValueKind.String) throw InvalidFile("version");
        var parts = version.GetString()!.Split('.');
        if (parts.Length != 2 || !int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out var major) || !int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out var minor)) throw InvalidFile("version");
        return major == Major ? minor : throw new SidecarVersionException(version.GetString()!);
    }

    internal static CornerMode CornersOf(string? word, string where) => word switch { null or "stop" => CornerMode.Stop, "continuous" => CornerMode.Continuous, _ => throw InvalidFile(where) };

    internal static string CornersWord(CornerMode corners) => corners == CornerMode.Stop ? "stop" : "continuous";
}
