using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Lettering;
using Engraver.Workbench.Lettering.Paragraphs;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>A drawing with the letters of texts as curves. Behind its entities, whose indices remain, is one for each of its texts, in their order: that of
/// a text without letters has no part.</summary>
/// <param name="Drawing">Its texts are those without letters.</param>
/// <param name="Texts">In the order of the drawing.</param>
/// <param name="Findings">Fonts, characters and codes; each once, with its first place.</param>
public sealed record LetteredDrawing(Drawing Drawing, IReadOnlyList<LetteredText> Texts, IReadOnlyList<Diagnostic> Findings)
{
    /// <summary>The fonts of the texts that are cut.</summary>
    public IReadOnlyList<CutFont> Fonts { get; init; } = [];

    /// <summary>Texts whose letters are not where a second calculation has them (VER0023).</summary>
    public IReadOnlyList<Diagnostic> Faults { get; init; } = [];

    /// <summary>A drawing none of whose texts is cut.</summary>
    public static LetteredDrawing None(Drawing drawing) => new(drawing, [], []);

    /// <param name="isTaken">The texts to make curves of.</param>
    /// <param name="maxError">Largest distance of the arcs of united outlines from the curves of the font, drawing units.</param>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static LetteredDrawing Of(Drawing drawing, Predicate<PlacedText> isTaken, LetterFonts fonts, double maxError, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(isTaken);
        ArgumentNullException.ThrowIfNull(fonts);
        var (added, findings) = (new AddedCurves(drawing), new LetteringFindings());
        var (done, rest) = (new List<LetteredText>(), new List<PlacedText>());
        foreach (var text in drawing.Texts)
        {
            cancellation.ThrowIfCancellationRequested();
            if (isTaken(text) && Letter(text, fonts, maxError, findings) is var (layout, curves))
            {
                done.Add(new LetteredText(added.Add(EntityOf(text, added), curves.Parts, curves.Curves), layout));
                continue;
            }

            added.Add(EntityOf(text, added), [], []);
            rest.Add(text);
        }

        return new LetteredDrawing(added.ToDrawing() with { Texts = rest, Cut = drawing.Cut | CutChoice.Text }, done, findings.Of(fonts)) { Fonts = CutFont.Of(done, fonts), Faults = findings.Faults };
    }

    /// <summary>The layout of a text of any type; null if it has no size.</summary>
    public static TextLayout? LayoutOf(PlacedText text, LetterFonts fonts)
    {
        ArgumentNullException.ThrowIfNull(text);
        return text.Written.Paragraphs is null ? LineLayout.Of(text, fonts) : ParagraphLayout.Of(text, fonts);
    }

    private static (TextLayout Layout, LetterCurves Curves)? Letter(PlacedText text, LetterFonts fonts, double maxError, LetteringFindings findings)
    {
        var source = text.Source;
        if (text.Written.DamagedGroup is not 0 and var group)
        {
            findings.AddDamaged(source, text.Content, group);
            return null;
        }

        if (LayoutOf(text, fonts) is not { } layout || IsFlattened(layout.Plane))
        {
            findings.AddNoSize(source, text.Content);
            return null;
        }

        findings.Add(source, layout.Notes);
        var curves = LetterCurves.Of(layout, maxError);
        if (!curves.IsInRange)
        {
            findings.AddOutOfRange(source, text.Content);
            return null;
        }

        if (curves.IsTilted) findings.AddTilted(source);
        if (!curves.IsUnited) findings.AddNotUnited(source, text.Content);
        if (MisplacementOf(text, layout, fonts, curves, maxError) is { } misplaced) findings.AddMisplaced(source, text.Content, misplaced);
        return (layout, curves);
    }

    /// <summary>True for a plane that a block without width or height makes a line or a point of.</summary>
    private static bool IsFlattened(in Placement plane)
    {
        const double Negligible = 1e-12;
        var area = plane.XAxis.Cross(plane.YAxis).Length;
        return !(area > Negligible * plane.XAxis.Length * plane.YAxis.Length) || area == 0.0;
    }

    private static Misplacement? MisplacementOf(PlacedText text, TextLayout layout, LetterFonts fonts, LetterCurves curves, double maxError)
    {
        if (text.Written.Paragraphs is null)
        {
            var style = fonts.StyleOf(text.Style);
            return LetterCheck.Find(LetterPlaces.Of(text, style, fonts.Of(style)), curves, maxError);
        }

        var places = ParagraphPlaces.Of(text, layout);
        if (!ParagraphPlaces.HasEveryLetter(text, layout)) return new Misplacement(double.PositiveInfinity, places.Origin);
        return LetterCheck.Find(places, curves, maxError);
    }

    private static DrawingEntity EntityOf(PlacedText text, AddedCurves added) => new()
    {
        SourceLine = (int)text.SourceLine,
        Insert = -text.BlockPath,
        Handle = text.Handle,
        Layer = text.Layer,
        Colour = text.Colour,
        LineStyle = added.StyleOf(text.Lineweight),
        Type = text.Type switch { "MTEXT" => CurveType.MText, "ATTRIB" => CurveType.Attribute, _ => CurveType.Text },
        Hidden = text.Hidden,
    };
}
