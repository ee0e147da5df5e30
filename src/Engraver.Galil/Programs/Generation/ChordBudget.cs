using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Counts the chords that arcs will need before any is generated, because arcs of huge radius could need too much time and memory.</summary>
internal static class ChordBudget
{
    /// <summary>Maximum number of chords of a drawing; a program with more lines is never posted or sent.</summary>
    public const int MaxChords = 1_000_000;

    /// <summary>The error that names the arc with the most chords; null while the drawing needs at most <see cref="MaxChords"/>.</summary>
    /// <param name="toolpath">All coordinates are finite and fit counts at this scale.</param>
    /// <param name="scale">Counts per millimetre.</param>
    /// <param name="maxErrorMm">Largest distance of chords from an arc, millimetres.</param>
    /// <param name="source">Position of an entity in the drawing's file.</param>
    public static Diagnostic? Refusal(Toolpath toolpath, CountsScale scale, double maxErrorMm, Func<int, SourceRef> source)
    {
        var error = ArcChords.ErrorOf(maxErrorMm, scale);
        var (all, most, worst) = (0.0, 0.0, default(StrokeMove));
        foreach (var stroke in toolpath.Strokes)
        {
            foreach (var move in stroke.Moves)
            {
                if (move.Segment.Kind == SegmentKind.Line || (scale.IsUniform && ArcCommandFit.CanHold(scale.Exact(move.Segment.Arc).Radius))) continue;
                var count = ArcChords.Count(move.Segment.Arc, error);
                all += count;
                if (count > most) (most, worst) = (count, move);
            }
        }

        if (all <= MaxChords) return null;
        var arcs = scale.IsUniform ? Wording.Get("ChordBudget.ArcsUpToRadius", NumberText.Rounded(scale.Finer.LengthOf(DmcLimits.LargestRadius), 3)) : Wording.Get("ChordBudget.NoArcs");
        return MotionRules.TooManyChords.At(source(worst.EntityIndex), NumberText.Rounded(all, 3), NumberText.Rounded(MaxChords, 3), NumberText.Rounded(worst.Segment.Arc.Radius, 3), NumberText.Rounded(most, 3), arcs);
    }
}
