using System.Text.Json.Serialization;

namespace Engraver.Workbench.Certificates;

/// <summary>The proof that a program was read back and does what a drawing says: of what exactly, and what was found. Lengths in millimetres of the
/// drawing.</summary>
public sealed record JobCertificate
{
    /// <summary>The form of the file that this program writes.</summary>
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

    /// <summary>True: the program runs to its end, cuts all of the drawing and nothing else.</summary>
    public required bool Ok { get; init; }

    /// <summary>Largest distance of what is cut from the drawing; null when nothing was cut.</summary>
    public required double? MaxDeviation { get; init; }

    /// <summary>How large it may be.</summary>
    public required double Tolerance { get; init; }

    /// <summary>Length of the drawing that the program does not cut.</summary>
    public required double MissingLength { get; init; }

    /// <summary>Length that it cuts beside the drawing.</summary>
    public required double ExtraLength { get; init; }

    /// <summary>Null when nothing is cut.</summary>
    public required CertifiedLimits? Limits { get; init; }

    /// <summary>On the machine of the profile; null for a target that it does not run.</summary>
    public required double? PlannedSeconds { get; init; }

    /// <summary>What was found on the way, errors first.</summary>
    public required IReadOnlyList<CertifiedFinding> Findings { get; init; }
}

/// <param name="File">Its name without the folder.</param>
/// <param name="Sha256">Of its bytes; null where it cannot be read again.</param>
public sealed record CertifiedDrawing(string File, string? Sha256, long Bytes);

/// <param name="Target">Name of the post.</param>
/// <param name="File">Where it was read from, without the folder; null for one that was made for this.</param>
/// <param name="Sha256">Of its text, UTF-8.</param>
public sealed record CertifiedProgram(string Target, string? File, string Sha256, int Lines)
{
    /// <summary>The kind of controller by whose rules it was written and read back; null for a target that has only one, and for the usual one.</summary>
    public string? Dialect { get; init; }
}

/// <param name="Values">By the keys of docs/settings.md.</param>
public sealed record CertifiedSettings(string Sha256, IReadOnlyDictionary<string, string> Values);

/// <param name="Sha256">Of the profile in its full form.</param>
/// <param name="Feed">mm/min.</param>
/// <param name="Rapid">mm/min.</param>
public sealed record CertifiedProfile(string Sha256, double CountsPerMillimetreX, double CountsPerMillimetreY, double Feed, double Rapid);

/// <summary>The box of what is cut, and the travel of the machine.</summary>
/// <param name="TravelX">Length of the travel; null where the profile does not say.</param>
/// <param name="Fits">False where the box is larger than the travel. Where it lies is known when the work is placed.</param>
public sealed record CertifiedLimits(double MinX, double MinY, double MaxX, double MaxY, double? TravelX, double? TravelY, bool Fits)
{
    /// <summary>Height of the deepest cut, mm above the surface of the work; null where no axis holds the tool, or the target tells no heights.</summary>
    public double? MinZ { get; init; }

    /// <summary>The greatest height that the tool goes up to, as <see cref="MinZ"/>.</summary>
    public double? MaxZ { get; init; }

    /// <summary>Length of the travel in height; null where the profile does not say.</summary>
    public double? TravelZ { get; init; }
}

/// <param name="Severity">error, warning or info.</param>
/// <param name="Line">Of the drawing or the program; null for none.</param>
public sealed record CertifiedFinding(string Id, string Severity, int? Line, string Sentence);

[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, WriteIndented = true, NewLine = "\n", RespectNullableAnnotations = true, RespectRequiredConstructorParameters = true)]
[JsonSerializable(typeof(JobCertificate))]
internal sealed partial class CertificateJson : JsonSerializerContext;
