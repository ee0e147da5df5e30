using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.Json.Serialization.Metadata;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines.Profiles;

/// <summary>A machine profile as JSON: an object of the profile's properties in camel case; comments and trailing commas are allowed, fields that are missing
/// (or null) keep their default.</summary>
public static class MachineProfileFile
{
    private const string Jog = "jogMmPerMinute";

    /// <summary>Reads a profile and checks it against what the controller accepts. Every error is a diagnostic, with the line where the text itself is
    /// wrong.</summary>
    /// <param name="limits">Those of the controller of a profile that names no family.</param>
    /// <param name="families">The families that a profile may name; null for none.</param>
    public static MachineProfileReadResult Read(string json, MachineLimits limits, IReadOnlyList<IControllerFamily>? families = null)
    {
        var fields = JsonFields.Read(json);
        IReadOnlyList<Diagnostic> unknown = [.. fields.Unknown(Known).Select(field => MotionRules.ProfileFieldUnknown.At(new SourceRef(field.Line), field.Path, JsonFields.Nearest(field.Name, Known(field.Owner)!)))];
        try
        {
            var read = Checked(JsonSerializer.Deserialize(json, MachineProfileJson.Default.MachineProfileDocument), limits, families ?? [], isWhole: unknown.Count == 0);
            IReadOnlyList<Diagnostic> findings = [.. Written(read.Diagnostics, fields, isWhole: unknown.Count == 0).Select(finding => finding.Source == default ? finding with { Source = new SourceRef(fields.LineOf(finding.Facts[0])) } : finding)];
            return unknown.Count == 0 ? read with { Diagnostics = findings } : new MachineProfileReadResult(null, [.. unknown, .. findings]);
        }
        catch (JsonException trouble)
        {
            return new MachineProfileReadResult(null, [.. unknown, Finding(trouble)]);
        }
    }

    /// <summary>The findings about fields that are in the file. A jog speed that follows from the rapid speed is reported only where nothing else is wrong;
    /// beside an unknown field, a missing field may be that field.</summary>
    private static IEnumerable<Diagnostic> Written(IReadOnlyList<Diagnostic> findings, JsonFields fields, bool isWhole)
    {
        bool IsWritten(Diagnostic finding) => finding.Facts.Count == 0 || fields.LineOf(finding.Facts[0]) > 0;
        if (!isWhole) return findings.Where(finding => finding.Severity == Severity.Error && IsWritten(finding));
        return findings.Count > 1 ? findings.Where(finding => finding.Facts.Count == 0 || finding.Facts[0] != Jog || IsWritten(finding)) : findings;
    }

    /// <summary>The profile with every field, ready to be edited.</summary>
    public static string Write(MachineProfile profile) => JsonSerializer.Serialize(MachineProfileDocument.From(profile), MachineProfileJson.Default.MachineProfileDocument) + "\n";

    private static MachineProfileReadResult Checked(MachineProfileDocument? document, MachineLimits limits, IReadOnlyList<IControllerFamily> families, bool isWhole)
    {
        if (document is null) return new MachineProfileReadResult(null, [MotionRules.ProfileUnreadable.At(new SourceRef(1), Wording.Get("MachineProfileFile.NullInsteadOfObject"))]);
        var controller = families.FirstOrDefault(family => family.Key == document.Controller);
        if (document.Controller is { } unknown && controller is null) return new MachineProfileReadResult(null, [MotionRules.SettingOutOfRange.At(default, "controller", unknown, Wording.Get("MachineProfileValidation.OneOf", string.Join(", ", families.Select(family => family.Key))))]);
        var profile = document.Over(MachineProfile.Default, controller);
        IReadOnlyList<Diagnostic> findings = [.. document.WithoutEffect().Where(field => isWhole || field.Field == "toolDrive").Select(field => MotionRules.SettingOutOfRange.At(default, field.Field, Wording.Get("MachineProfileFile.AnyValue"), field.Needs)), .. MachineProfileValidation.Check(profile, controller?.Limits ?? limits)];
        if (document.TravelZ is not null && profile.Axes.Z is null) findings = [.. findings, MotionRules.SettingOutOfRange.At(default, "travelZ", Wording.Get("MachineProfileFile.AnyValue"), Wording.Get("MachineProfileValidation.NoAxisZ"))];
        if (document.HomingsWithoutAxis(profile.Axes).FirstOrDefault() is { } axis) findings = [.. findings, MotionRules.SettingOutOfRange.At(default, "homing.axis", axis, Wording.Get("MachineProfileValidation.HomingAxis"))];
        return findings.Count == 0 ? new MachineProfileReadResult(profile, [.. ProfileContradictions.Find(profile), .. Ignored(document)]) : new MachineProfileReadResult(null, findings);
    }

    private static IEnumerable<Diagnostic> Ignored(MachineProfileDocument document) => document.SharpCornerDegrees is null ? [] : [MotionRules.ProfileFieldIgnored.At(default, "sharpCornerDegrees")];

    /// <summary>The names that are allowed in a field; null where any name is allowed: the numbers of inputs and outputs, and inside a field that is itself
    /// reported as unknown or without a value.</summary>
    private static List<string>? Known(string owner) => owner switch
    {
        "" => Names(MachineProfileJson.Default.MachineProfileDocument),
        "travelX" or "travelY" or "travelZ" => Names(MachineProfileJson.Default.TravelDocument),
        _ when owner.StartsWith("homing[", StringComparison.Ordinal) && owner.EndsWith(']') => Names(MachineProfileJson.Default.HomingDocument),
        _ => null,
    };

    private static List<string> Names(JsonTypeInfo type) => [.. type.Properties.Select(property => property.Name)];

    private static Diagnostic Finding(JsonException trouble)
    {
        var place = new SourceRef((trouble.LineNumber ?? 0) + 1);
        if (trouble.InnerException is JsonException) return MotionRules.ProfileUnreadable.At(place, Wording.Get("MachineProfileFile.NotJson", place.Line));
        var field = trouble.Path is ['$', '.', .. var name] ? name : string.Empty;
        if (field.Length == 0) return MotionRules.ProfileUnreadable.At(place, Wording.Get("MachineProfileFile.NotJsonObject"));
        return MotionRules.ProfileValueUnreadable.At(place, field); // an unknown field was reported before anything was read
    }
}

/// <summary>Reads and writes profile files without reflection. <see cref="JsonFields"/> reports unknown fields, with their lines.</summary>
[JsonSourceGenerationOptions(
    PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase,
    WriteIndented = true,
    AllowTrailingCommas = true,
    ReadCommentHandling = JsonCommentHandling.Skip,
    UnmappedMemberHandling = JsonUnmappedMemberHandling.Skip,
    AllowDuplicateProperties = false)]
[JsonSerializable(typeof(MachineProfileDocument))]
internal sealed partial class MachineProfileJson : JsonSerializerContext;
