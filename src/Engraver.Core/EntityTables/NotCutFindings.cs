using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.EntityTables;

/// <summary>Visible content of the layers that are cut which is not cut itself: texts, and construction such as hatches, dimensions and points. Refused
/// entities are not included; the drawing's balance lists them.</summary>
/// <param name="Counts">By DXF type, in the order of their names, blocks expanded; empty when everything visible is cut.</param>
/// <param name="First">Where the first of them is in the file.</param>
public sealed record NotCutFindings(IReadOnlyDictionary<string, int> Counts, SourceRef First)
{
    /// <param name="notTaken">Curves that are not cut either, by entity.</param>
    public static NotCutFindings From(Drawing drawing, LayerSelection selection, IReadOnlyList<int>? notTaken = null)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(selection);
        var taken = selection.Taken(drawing.Layers);
        var counts = new SortedDictionary<string, int>(StringComparer.Ordinal);
        var first = default(SourceRef?);
        foreach (var text in drawing.Texts)
        {
            if (!text.Hidden && taken[text.Layer]) Add(text.Type, 1, text.Source);
        }

        foreach (var (type, layer, count, source) in drawing.Construction)
        {
            if (taken[layer]) Add(type, count, source);
        }

        var types = new HashSet<string>();
        foreach (var entity in notTaken ?? [])
        {
            types.Add(drawing.Entities[entity].Type.ToDxfName());
            Add(drawing.Entities[entity].Type.ToDxfName(), 1, drawing.SourceOf(entity));
        }

        return new NotCutFindings(counts, first ?? default) { CutsTexts = drawing.Cut.HasFlag(CutChoice.Text), NotTaken = types };

        void Add(string type, int count, SourceRef source)
        {
            counts[type] = (int)Math.Min((long)counts.GetValueOrDefault(type) + count, int.MaxValue);
            if (first is not { } known || source.Line < known.Line) first = source;
        }
    }

    /// <summary>The types of curves that no operation takes.</summary>
    private IReadOnlySet<string> NotTaken { get; init; } = new HashSet<string>();

    /// <summary>Texts are cut: those that remain have a fault that is reported.</summary>
    private bool CutsTexts { get; init; }

    /// <summary>For example "1 HATCH, 2 TEXT"; "" when there is none.</summary>
    public string Subject => string.Join(", ", Counts.Select(pair => FormattableString.Invariant($"{pair.Value} {pair.Key}")));

    /// <summary>The same as a part of a sentence about a job; "" when there is none.</summary>
    public string Clause => Counts.Count == 0 ? "" : Wording.Get("NotCutFindings.VisibleNotCut", Subject);

    /// <summary>How to have it cut, as consecutive instructions, with settings named by their keys; "" when there is none.</summary>
    public string HowTo
    {
        get
        {
            var ways = Counts.Keys.Where(type => !NotTaken.Contains(type)).ToLookup(WayOf);
            var parts = new List<string>();
            if (NotTaken.Count > 0) parts.Add(Wording.Get("NotCutFindings.NotTaken", string.Join(", ", NotTaken.Order(StringComparer.Ordinal))));
            if (ways.Contains("NotCutFindings.Texts")) parts.Add(Wording.Get(CutsTexts ? "NotCutFindings.FaultyTexts" : "NotCutFindings.Texts"));
            if (ways.Contains("NotCutFindings.Points")) parts.Add(Wording.Get("NotCutFindings.Points"));
            if (ways.Contains("NotCutFindings.Outlines")) parts.Add(Wording.Get("NotCutFindings.Outlines", string.Join(", ", ways["NotCutFindings.Outlines"].Select(ChoiceOf).Distinct())));
            if (ways.Contains("NotCutFindings.Others")) parts.Add(Wording.Get("NotCutFindings.Others", string.Join(", ", ways["NotCutFindings.Others"])));
            return string.Join("; ", parts);
        }
    }

    /// <summary>The possible action for a type of entity: not every type is allowed in [cut].</summary>
    private static string WayOf(string type) => type switch
    {
        "POINT" => "NotCutFindings.Points",
        _ when ChoiceOf(type) is not null => "NotCutFindings.Outlines",
        _ when type.Contains("TEXT", StringComparison.Ordinal) || type.StartsWith("ATT", StringComparison.Ordinal) => "NotCutFindings.Texts",
        _ => "NotCutFindings.Others",
    };

    /// <summary>The word of [cut] for a type; null for a type that it does not include.</summary>
    private static string? ChoiceOf(string type) => RecordKinds.ChoiceOf(RecordKinds.Find(type)) is not CutChoice.None and var choice ? choice.ToString().ToLowerInvariant() : null;

    /// <summary>The finding about this content; null when there is none.</summary>
    public Diagnostic? Finding => Counts.Count == 0 ? null : PreparationRules.NotCut.At(First, Subject) with { Advice = Wording.Get("NotCutFindings.Advice", HowTo) };
}
