using System.Reflection;
using System.Text.Json;
using Engraver.Core.Diagnostics;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>Checks a faults file (docs/simulator-fidelity.md), which is edited by hand, and reports errors with their lines.</summary>
public static class FaultFile
{
    private static readonly List<string> s_kinds = [.. Enum.GetNames<FaultKind>().Select(JsonNamingPolicy.CamelCase.ConvertName)];

    /// <summary>All errors; empty for a valid file.</summary>
    public static IReadOnlyList<Diagnostic> Findings(string json)
    {
        var fields = JsonFields.Read(json);
        IReadOnlyList<Diagnostic> unknown = [.. fields.Unknown(Known).Select(field => FaultFileRules.FieldUnknown.At(new SourceRef(field.Line), field.Path, JsonFields.Nearest(field.Name, Known(field.Owner)!)))];
        if (unknown.Count > 0) return unknown;
        try
        {
            FaultPlan.Parse(json);
            return [];
        }
        catch (FaultPlanException unusable)
        {
            var fault = $"faults[{unusable.Fault}]";
            var kind = fields.Find($"{fault}.kind")?.Text;
            return [FaultFileRules.FaultUnusable.At(new SourceRef(fields.LineOf($"{fault}.{unusable.Error.Field}")), fault, Reason(unusable.Error, kind))];
        }
        catch (JsonException unreadable)
        {
            return [Unreadable(unreadable, fields)];
        }
    }

    private static Diagnostic Unreadable(JsonException failure, JsonFields fields)
    {
        var place = new SourceRef((failure.LineNumber ?? 0) + 1);
        var path = failure.Path is ['$', '.', .. var below] ? below : "";
        if (failure.InnerException is JsonException || path.Length == 0) return FaultFileRules.NoJson.At(place, Wording.Get(failure.InnerException is JsonException ? "FaultFile.NoJson" : "FaultFile.NoObject"));
        var name = path[(path.LastIndexOf('.') + 1)..];
        if (path.StartsWith("faults[", StringComparison.Ordinal) && path.EndsWith(']') && fields.Find(path + ".kind") is null && fields.HasAny(path)) return FaultFileRules.FaultUnusable.At(place, path, Wording.Get("FaultFile.NoKind", string.Join(", ", s_kinds)));
        if (name != "kind") return FaultFileRules.ValueUnreadable.At(place, path, Expected(TypeOf(path)));
        var typed = fields.Find(path)?.Text;
        return FaultFileRules.ValueUnreadable.At(place, path, typed is null ? Wording.Get("FaultFile.OneOf", string.Join(", ", s_kinds)) : Wording.Get("FaultFile.OneOfNearest", string.Join(", ", s_kinds), JsonFields.Nearest(typed, s_kinds)));
    }

    private static string Reason(FaultError flaw, string? kind) => flaw.Reason switch
    {
        FaultErrorReason.Moments => Wording.Get("FaultFile.OneMoment"),
        FaultErrorReason.NoAxis => Wording.Get("FaultFile.NoAxis", kind),
        FaultErrorReason.HasNoAxis => Wording.Get("FaultFile.HasNoAxis", kind),
        FaultErrorReason.OtherAxis => Wording.Get("FaultFile.InvalidAxis"),
        FaultErrorReason.NeverEnds => Wording.Get("FaultFile.NoDuration", kind),
        FaultErrorReason.NotAboveZero => Wording.Get("FaultFile.NotAboveZero", flaw.Field),
        FaultErrorReason.BelowOne => Wording.Get("FaultFile.BelowOne", flaw.Field),
        _ when flaw.Field is "atSeconds" => Wording.Get("FaultFile.SecondsOutOfRange", flaw.Field, 1e9),
        _ when flaw.Field is "seconds" => Wording.Get("FaultFile.SecondsOutOfRange", flaw.Field, 1e6),
        _ => Wording.Get("FaultFile.BelowZero", flaw.Field),
    };

    /// <summary>The allowed names in an object; null if it is not an object of the file.</summary>
    private static List<string>? Known(string owner) => OwnerOf(owner) is { } type ? [.. Properties(type).Select(property => JsonNamingPolicy.CamelCase.ConvertName(property.Name))] : null;

    private static Type? OwnerOf(string owner) => owner.Length == 0 ? typeof(FaultPlan)
        : owner.StartsWith("faults[", StringComparison.Ordinal) ? typeof(ScheduledFault)
        : owner.StartsWith("refusals[", StringComparison.Ordinal) ? typeof(CommandRefusal)
        : owner.StartsWith("drops[", StringComparison.Ordinal) ? typeof(HandleDrop) : null;

    private static PropertyInfo[] Properties(Type type) => type.GetProperties(BindingFlags.Public | BindingFlags.Instance);

    /// <summary>Type of the value at a path; an entry of a list is an object.</summary>
    private static Type TypeOf(string path)
    {
        if (path.EndsWith(']')) return typeof(FaultPlan);
        var dot = path.LastIndexOf('.');
        var owner = OwnerOf(dot < 0 ? "" : path[..dot]) ?? typeof(FaultPlan);
        var type = Properties(owner).First(property => JsonNamingPolicy.CamelCase.ConvertName(property.Name) == path[(dot + 1)..]).PropertyType;
        return Nullable.GetUnderlyingType(type) ?? type;
    }

    private static string Expected(Type type) => Wording.Get(
        type == typeof(bool) ? "FaultFile.Switch"
        : type == typeof(string) ? "FaultFile.AxisText"
        : type == typeof(TimeSpan) ? "FaultFile.Time"
        : type == typeof(double) ? "FaultFile.Number"
        : type.IsPrimitive ? "FaultFile.WholeNumber"
        : type == typeof(FaultPlan) ? "FaultFile.Object" : "FaultFile.List");
}
