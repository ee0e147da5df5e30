using Engraver.Core.TextMarkup;
using Engraver.Fonts.Finding;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>A format of an MTEXT with what its entity and style state in the place of what it leaves out.</summary>
/// <param name="Blank">Advance of a blank.</param>
internal sealed record SetFormat(FoundFont Font, LetterFormat Letters, LineMarks Marks, LineAlignment Alignment, double Blank)
{
    public double Height => Letters.Height;
}
