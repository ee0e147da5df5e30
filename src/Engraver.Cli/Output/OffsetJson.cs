using Engraver.Core.Offsets;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver offset --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="MaxDeviation">Largest difference between the requested and the measured distance, mm.</param>
internal sealed record OffsetJson(IReadOnlyList<OffsetJson.LoopJson> Loops, double MaxDeviation)
{
    public static OffsetJson From(OffsetResult result) => new(
        [.. result.Loops.Select(loop => new LoopJson(loop.Closed, loop.Lines, loop.Arcs, loop.Length, Math.Abs(loop.SignedArea), loop.IsHole))],
        result.MaxDeviation);

    public static void Text(TextWriter output, OffsetDrawing offset)
    {
        var loops = offset.Result.Loops;
        output.WriteLine(Wording.Get("Offset.Loops", loops.Count, loops.Count(loop => loop.Closed), loops.Sum(loop => loop.Length)));
        foreach (var loop in loops)
        {
            output.WriteLine(loop.Closed
                ? Wording.Get(loop.IsHole ? "Offset.Hole" : "Offset.ClosedLoop", loop.Lines, loop.Arcs, loop.Length, Math.Abs(loop.SignedArea))
                : Wording.Get("Offset.OpenLoop", loop.Lines, loop.Arcs, loop.Length));
        }

        output.WriteLine(Wording.Get("Offset.MaxDeviation", offset.Result.MaxDeviation));
    }

    /// <param name="Area">Area enclosed by this loop alone, mm2, never negative; 0 when open.</param>
    /// <param name="Hole">The material is outside the loop (it runs clockwise).</param>
    internal sealed record LoopJson(bool Closed, int Lines, int Arcs, double Length, double Area, bool Hole);
}
