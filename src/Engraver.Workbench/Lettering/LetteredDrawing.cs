using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Workbench.Lettering;

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
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static LetteredDrawing Of(Drawing drawing, Predicate<PlacedText> isTaken, LetterFonts fonts, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(isTaken);
        ArgumentNullException.ThrowIfNull(fonts);
        var (added, findings) = (new AddedCurves(drawing), new LetteringFindings());
        var (done, rest) = (new List<LetteredText>(), new List<PlacedText>());
        for (var index = 0; index < drawing.Texts.Count; index++)
        {
            cancellation.ThrowIfCancellationRequested();
            var text = drawing.Texts[index];
            if (text.Written.Paragraphs is null && isTaken(text) && Letter(text, fonts, findings) is var (layout, curves))
            {
                done.Add(new LetteredText(index, added.Add(EntityOf(text), curves.Parts, curves.Curves), layout));
                continue;
            }

            added.Add(EntityOf(text), [], []);
            rest.Add(text);
        }

        return new LetteredDrawing(added.ToDrawing() with { Texts = rest }, done, findings.Of(fonts)) { Fonts = CutFont.Of(done, fonts), Faults = findings.Faults };
    }

    private static (TextLayout Layout, LetterCurves Curves)? Letter(PlacedText text, LetterFonts fonts, LetteringFindings findings)
    {
        var source = SourceOf(text);
        if (LineLayout.Of(text, fonts) is not { } layout)
        {
            findings.AddNoSize(source, text.Content);
            return null;
        }

        findings.Add(source, layout.Notes);
        var curves = LetterCurves.Of(layout);
        if (!curves.IsInRange)
        {
            findings.AddOutOfRange(source, text.Content);
            return null;
        }

        if (curves.IsTilted) findings.AddTilted(source);
        if (LetterCheck.Find(LetterPlaces.Of(text, fonts.StyleOf(text.Style), fonts.Of(fonts.StyleOf(text.Style))), curves) is { } misplaced) findings.AddMisplaced(source, text.Content, misplaced);
        return (layout, curves);
    }

    private static DrawingEntity EntityOf(PlacedText text) => new()
    {
        SourceLine = text.SourceLine,
        Handle = text.Handle,
        Layer = text.Layer,
        Colour = text.Colour,
        Type = text.Type switch { "MTEXT" => CurveType.MText, "ATTRIB" => CurveType.Attribute, _ => CurveType.Text },
        Hidden = text.Hidden,
    };

    private static SourceRef SourceOf(PlacedText text) => new(text.SourceLine, text.Handle == 0 ? null : text.Handle.ToString("X", CultureInfo.InvariantCulture));
}
