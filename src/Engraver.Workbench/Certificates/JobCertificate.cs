using System.Text.Json.Serialization;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Certificates;

/// <summary>Certificate that a program was read back and compared with a drawing: the inputs and the findings. Lengths in millimetres of the drawing.</summary>
public sealed record JobCertificate
{
    /// <summary>Version of the file format.</summary>
    public const int CurrentVersion = 1;

    public int Version { get; init; } = CurrentVersion;

    /// <summary>When the program was read back, UTC.</summary>
    public required DateTimeOffset Issued { get; init; }

    /// <summary>The program that read it back, with its version.</summary>
    public required string IssuedBy { get; init; }

    public required CertifiedDrawing Drawing { get; init; }

    public required CertifiedProgram Program { get; init; }

    public required CertifiedSettings Settings { get; init; }

    public required CertifiedProfile Profile { get; init; }

    /// <summary>The values of the texts; left out where they have no fields.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public string? Plate { get; init; }

    /// <summary>True: the program runs to its end and cuts the whole drawing and nothing else.</summary>
    public required bool Ok { get; init; }

    /// <summary>Largest distance between cut and drawing; null when nothing was cut.</summary>
    public required double? MaxDeviation { get; init; }

    /// <summary>Largest distance between cut and drawing where corners are rounded within the corner tolerance; left out where they may not be
    /// rounded.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public double? CornerDeviation { get; init; }

    /// <summary>The allowed deviation.</summary>
    public required double Tolerance { get; init; }

    /// <summary>Length of the drawing that the program does not cut.</summary>
    public required double MissingLength { get; init; }

    /// <summary>Length that the program cuts in addition to the drawing.</summary>
    public required double ExtraLength { get; init; }

    /// <summary>What was measured of each operation; left out without operations.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<MeasuredOperation>? Operations { get; init; }

    /// <summary>Null when nothing is cut.</summary>
    public required CertifiedLimits? Limits { get; init; }

    /// <summary>Planned duration on the machine of the profile; null for a target that it does not run.</summary>
    public required double? PlannedSeconds { get; init; }

    /// <summary>Findings, errors first.</summary>
    public required IReadOnlyList<CertifiedFinding> Findings { get; init; }

    /// <summary>The fonts of the texts that are cut as curves; empty if no text is cut, and in certificates of an earlier version.</summary>
    public IReadOnlyList<CutFont> Fonts { get; init; } = [];
}

/// <param name="File">File name without the folder.</param>
/// <param name="Sha256">Hash of its bytes; null if it cannot be read again.</param>
public sealed record CertifiedDrawing(string File, string? Sha256, long Bytes);

/// <param name="Target">Name of the post.</param>
/// <param name="File">File name without the folder; null for a program posted for the certificate.</param>
/// <param name="Sha256">Hash of its text, UTF-8.</param>
public sealed record CertifiedProgram(string Target, string? File, string Sha256, int Lines)
{
    /// <summary>The kind of controller by whose rules it was written and read back; null for the default, or if the target has only one.</summary>
    public string? Dialect { get; init; }
}

/// <param name="Values">By the keys of docs/settings.md.</param>
public sealed record CertifiedSettings(string Sha256, IReadOnlyDictionary<string, string> Values);

/// <param name="Sha256">Of the profile in its full form.</param>
/// <param name="Feed">mm/min.</param>
/// <param name="Rapid">mm/min.</param>
public sealed record CertifiedProfile(string Sha256, double CountsPerMillimetreX, double CountsPerMillimetreY, double Feed, double Rapid);

/// <param name="Severity">error, warning or info.</param>
/// <param name="Line">Line of the drawing or the program; null for none.</param>
public sealed record CertifiedFinding(string Id, string Severity, int? Line, string Sentence);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", RespectNullableAnnotations = true, RespectRequiredConstructorParameters = true)]
[JsonSerializable(typeof(JobCertificate))]
internal sealed partial class CertificateJson : JsonSerializerContext;
