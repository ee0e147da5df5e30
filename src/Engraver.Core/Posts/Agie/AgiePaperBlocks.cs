using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts.Agie;

/// <summary>Blocks as defined by paper 000: one for each entity, its increments, or its radius and angles rounded to whole degrees, independent of the actual
/// machine position.</summary>
/// <remarks>The paper does not define a full turn or an arc below half a degree: here the first becomes two half turns, the second its chord.</remarks>
internal static class AgiePaperBlocks
{
    /// <param name="path">Lines, arcs and circles.</param>
    public static AgieSteps Write(Toolpath path)
    {
        var steps = new AgieSteps(path.Strokes[0].Start);
        var tool = path.Strokes[0].Start;
        foreach (var stroke in path.Strokes)
        {
            steps.For = (stroke.Index, -1);
            steps.Line((stroke.Start - tool) * 1000.0, drawn: null);
            for (var move = 0; move < stroke.Moves.Count; move++)
            {
                steps.For = (stroke.Index, move);
                Add(steps, stroke.Moves[move].Segment);
            }

            tool = stroke.End;
        }

        return steps;
    }

    private static void Add(AgieSteps steps, Segment drawn)
    {
        var work = drawn.Kind == SegmentKind.Line ? 0 : (int)AgieSteps.Rounded(Math.Abs(drawn.Arc.Sweep.Degrees));
        if (work == 0)
        {
            steps.Line((drawn.End - drawn.Start) * 1000.0, drawn);
            return;
        }

        var (isClockwise, start, radius) = (drawn.Arc.Sweep.Degrees < 0.0, (int)AgieSteps.Rounded(drawn.Arc.Start.Positive().Degrees), (int)AgieSteps.Rounded(drawn.Arc.Radius * 1000.0));
        if (work < 360)
        {
            steps.Add(AgieBlock.Arc(isClockwise, start, work, radius), drawn);
            return;
        }

        steps.Add(AgieBlock.Arc(isClockwise, start, 180, radius), drawn);
        steps.Add(AgieBlock.Arc(isClockwise, start + 180, 180, radius), drawn);
    }

    /// <summary>The first arc whose radius the paper's format cannot hold: rounded to 0 or to more than six digits; null when there is none.</summary>
    public static int? Unwritable(Toolpath path)
    {
        foreach (var move in path.Strokes.SelectMany(stroke => stroke.Moves))
        {
            if (move.Segment.Kind != SegmentKind.Line && AgieSteps.Rounded(move.Segment.Arc.Radius * 1000.0) is < 1.0 or > AgieBlock.Largest && AgieSteps.Rounded(Math.Abs(move.Segment.Arc.Sweep.Degrees)) > 0.0) return move.EntityIndex;
        }

        return null;
    }
}
