using Engraver.Core.Sequencing;

namespace Engraver.Benchmarks.Ordering;

/// <summary>Checks an order by the shapes of the generator alone.</summary>
internal static class OrderJudge
{
    /// <summary>Strokes that are cut after the one around them, not at all, or more than once.</summary>
    public static int Violations(OrderInstance instance, int[] shapeOf, SequencingResult order)
    {
        var places = Enumerable.Repeat(-1, instance.Shapes.Count).ToArray();
        var wrong = Math.Abs(order.Strokes.Count - instance.Shapes.Count);
        for (var place = 0; place < order.Strokes.Count; place++)
        {
            var shape = shapeOf[order.Strokes[place].Moves[0].EntityIndex];
            if (places[shape] >= 0) wrong++;
            places[shape] = place;
        }

        for (var shape = 0; shape < places.Length; shape++)
        {
            var around = instance.Shapes[shape].Around;
            if (places[shape] < 0 || (around >= 0 && places[around] < places[shape])) wrong++;
        }

        return wrong;
    }
}
