using System.Runtime.CompilerServices;
using Engraver.Core.Drawings;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>A drawing as it is shown and picked: its visible texts as the curves that would be cut, whether they are cut or not. Entity index
/// <c>n + k</c> is the text <c>k</c> of a drawing of <c>n</c> curves, as in the drawing of a job that cuts texts.</summary>
public static class ShownDrawing
{
    /// <summary>Number of drawings whose letters are kept: the present one, the one before an edit, one that is previewed. An undo history would hold too
    /// many.</summary>
    private const int MaxKept = 3;

    /// <summary>Largest distance of the arcs of united outlines from the curves of the font, millimetres.</summary>
    private const double MaxErrorMm = 0.00025;

    private static readonly Lock s_guard = new();
    private static readonly ConditionalWeakTable<Drawing, Known> s_known = [];

    /// <summary>What the fields in the texts of a drawing are shown as.</summary>
    private static readonly ConditionalWeakTable<Drawing, PlateValues> s_values = [];

    /// <summary>The drawings whose letters are kept, the last one first.</summary>
    private static readonly LinkedList<WeakReference<Drawing>> s_recent = new();

    /// <summary>The drawing with its letters; the drawing itself if it has no text. Computed once for each drawing, which takes a while for thousands of
    /// texts; after an edit only the letters of changed texts are computed.</summary>
    public static Drawing Of(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        if (drawing.Texts.Count == 0) return drawing;
        Known? known;
        lock (s_guard)
        {
            if (!s_known.TryGetValue(drawing, out known)) known = Keep(drawing);
        }

        return known.Shown.Value;
    }

    /// <summary>Shows the fields in the texts of a drawing as these values, until others are stated.</summary>
    public static void Fill(Drawing drawing, PlateValues values)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(values);
        lock (s_guard)
        {
            if (ValuesOf(drawing) == values) return;
            s_values.AddOrUpdate(drawing, values);
            if (s_known.TryGetValue(drawing, out _)) Keep(drawing);
        }
    }

    /// <summary>The values with which a drawing is shown.</summary>
    public static PlateValues ValuesOf(Drawing drawing) => s_values.TryGetValue(drawing, out var values) ? values : PlateValues.None;

    /// <summary>The letters of texts that a drawing could have, for previews: a drawing with one entity for each.</summary>
    /// <param name="drawing">Its layers and styles are used.</param>
    public static Drawing LettersOf(Drawing drawing, IReadOnlyList<PlacedText> texts) => LettersOf(drawing, texts, _ => true);

    /// <summary>Index of the text of an entity of the shown drawing; null for a curve.</summary>
    public static int? TextOf(Drawing drawing, int entity)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return entity >= drawing.Entities.Count && entity - drawing.Entities.Count < drawing.Texts.Count ? entity - drawing.Entities.Count : null;
    }

    private static Known Keep(Drawing drawing)
    {
        var recent = s_recent.Select(kept => kept.TryGetTarget(out var target) ? target : null).FirstOrDefault(kept => kept is not null && IsEditOf(drawing, kept));
        var before = recent is not null && s_known.TryGetValue(recent, out var known) && known.Shown.IsValueCreated ? known : null;
        var (filled, shownBefore) = (FilledTexts.Of(drawing, ValuesOf(drawing)), before?.Shown.Value);
        var created = new Known(filled, new Lazy<Drawing>(() => before is null || shownBefore is null ? Lettered(filled) : Edited(filled, before.Filled, shownBefore)));
        if (s_known.TryGetValue(drawing, out _)) Forget(drawing);
        s_known.Add(drawing, created);
        s_recent.AddFirst(new WeakReference<Drawing>(drawing));
        while (s_recent.Count > MaxKept)
        {
            if (s_recent.Last!.Value.TryGetTarget(out var oldest)) s_known.Remove(oldest);
            s_recent.RemoveLast();
        }

        return created;
    }

    private static void Forget(Drawing drawing)
    {
        s_known.Remove(drawing);
        for (var node = s_recent.First; node is not null; node = node.Next)
        {
            if (!node.Value.TryGetTarget(out var kept) || !ReferenceEquals(kept, drawing)) continue;
            s_recent.Remove(node);
            return;
        }
    }

    /// <summary>True if a text that both drawings have is shown by the same curves.</summary>
    private static bool IsEditOf(Drawing drawing, Drawing before) =>
        before.FileName == drawing.FileName && ReferenceEquals(before.Styles, drawing.Styles) && ReferenceEquals(before.Layers, drawing.Layers) && before.Scale == drawing.Scale;

    private static Drawing Lettered(Drawing drawing) => Letters(drawing, text => text.IsVisibleIn(drawing));

    /// <summary>The letters of unchanged texts are taken from the drawing before.</summary>
    private static Drawing Edited(Drawing drawing, Drawing before, Drawing shownBefore)
    {
        var known = new Dictionary<PlacedText, int>(ReferenceEqualityComparer.Instance);
        for (var text = 0; text < before.Texts.Count; text++) known[before.Texts[text]] = before.Entities.Count + text;
        var letters = LettersOf(drawing, [.. drawing.Texts.Where(text => !known.ContainsKey(text))], text => text.IsVisibleIn(drawing));
        var (added, next) = (new AddedCurves(drawing), 0);
        foreach (var text in drawing.Texts)
        {
            if (known.TryGetValue(text, out var old)) Add(added, shownBefore, old);
            else Add(added, letters, next++);
        }

        return added.ToDrawing();
    }

    private static void Add(AddedCurves added, Drawing from, int entity)
    {
        var row = from.Entities[entity];
        var (parts, curves) = (new DrawingPart[row.PartCount], new List<Core.Geometry.RationalCurve>());
        for (var part = 0; part < parts.Length; part++)
        {
            parts[part] = from.Parts[row.FirstPart + part];
            if (!parts[part].IsFreeCurve) continue;
            curves.Add(from.Curves[parts[part].CurveIndex]);
            parts[part] = DrawingPart.FreeCurve(0, curves[^1].Kind, curves.Count - 1);
        }

        row.LineStyle = added.StyleOf(from.LineStyles[row.LineStyle].Lineweight);
        added.Add(row, parts, curves);
    }

    private static Drawing LettersOf(Drawing drawing, IReadOnlyList<PlacedText> texts, Predicate<PlacedText> isTaken)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var bare = drawing with { Entities = new GrowingColumn<DrawingEntity>(), Parts = new GrowingColumn<DrawingPart>(), Curves = [], Points = [], Texts = texts };
        return Letters(bare, isTaken);
    }

    private static Drawing Letters(Drawing drawing, Predicate<PlacedText> isTaken) =>
        LetteredDrawing.Of(drawing, isTaken, LetterLibrary.FontsOf(drawing), drawing.Scale.ToDrawing(MaxErrorMm), CancellationToken.None).Drawing;

    /// <param name="Filled">The drawing with the fields in its texts filled.</param>
    /// <param name="Shown">With its letters.</param>
    private sealed record Known(Drawing Filled, Lazy<Drawing> Shown);
}
