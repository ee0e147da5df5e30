using System.Runtime.CompilerServices;
using Engraver.Core.Drawings;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>A drawing as it is shown and picked: its visible texts as the curves that would be cut, whether they are cut or not. Entity index
/// <c>n + k</c> is the text <c>k</c> of a drawing of <c>n</c> curves, as in the drawing of a job that cuts texts.</summary>
public static class ShownDrawing
{
    /// <summary>Largest distance of united outlines from the curves of the font as they are shown.</summary>
    private const double ShownErrorMm = 0.001;

    private static readonly ConditionalWeakTable<Drawing, Lazy<Drawing>> s_known = [];

    /// <summary>The drawing with its letters; the drawing itself if it has no text. Computed once for each drawing, which takes a while for thousands of
    /// texts.</summary>
    public static Drawing Of(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return drawing.Texts.Count == 0 ? drawing : s_known.GetValue(drawing, Create).Value;
    }

    /// <summary>The same with texts that are changed or added. Not kept: for previews.</summary>
    /// <param name="texts">The texts to show.</param>
    /// <returns>Only the letters of these texts, one entity for each.</returns>
    public static Drawing LettersOf(Drawing drawing, IReadOnlyList<PlacedText> texts)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var bare = drawing with { Entities = new GrowingColumn<DrawingEntity>(), Parts = new GrowingColumn<DrawingPart>(), Curves = [], Points = [], Texts = texts };
        return Lettered(bare);
    }

    /// <summary>Index of the text of an entity of the shown drawing; null for a curve.</summary>
    public static int? TextOf(Drawing drawing, int entity)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return entity >= drawing.Entities.Count && entity - drawing.Entities.Count < drawing.Texts.Count ? entity - drawing.Entities.Count : null;
    }

    private static Lazy<Drawing> Create(Drawing drawing) => new(() => Lettered(drawing));

    private static Drawing Lettered(Drawing drawing) =>
        LetteredDrawing.Of(drawing, text => text.IsVisibleIn(drawing), LetterLibrary.FontsOf(drawing), drawing.Scale.ToDrawing(ShownErrorMm), CancellationToken.None).Drawing;
}
