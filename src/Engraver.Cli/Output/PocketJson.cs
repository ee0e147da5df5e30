using System.Globalization;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Workbench.Documents;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver pocket --json</c> prints; names, units and meanings are the runner's contract.</summary>
/// <param name="Loops">The passes of one level of depth.</param>
/// <param name="MaxDeviation">Largest difference between the actual and the nominal distance of a pass from the walls, mm.</param>
/// <param name="Coverage">Covered fraction of the reachable area, 0 to 1; null if the tool reaches nothing.</param>
/// <param name="Strokes">Cuts without a lift, in order, separately for each level.</param>
/// <param name="Stepover">Distance between neighbouring passes as a fraction of the tool diameter.</param>
/// <param name="PassDistance">The same in mm.</param>
/// <param name="PassOverlap">Overlap of two neighbouring passes, mm.</param>
internal sealed record PocketJson(
    IReadOnlyList<PocketJson.PocketPassJson> Loops, double MaxDeviation, int Regions, double DrawnArea, double ReachableArea, double CoveredArea, double UncoveredArea, double? Coverage, double UnreachableArea,
    IReadOnlyList<PocketJson.PocketPlaceJson> Unreached, IReadOnlyList<PocketJson.PocketNarrowJson> TooNarrow, IReadOnlyList<double> Levels, IReadOnlyList<PocketJson.PocketStrokeJson> Strokes,
    double Stepover, double PassDistance, double PassOverlap)
{
    public static PocketJson From(PocketDrawing pocket, PocketOptions options, PocketDepths depths)
    {
        var result = pocket.Result;
        return new PocketJson(
            [.. result.Passes.Select(PassOf)], result.MaxDeviation, result.Regions, result.DrawnArea, result.ReachableArea, result.CoveredArea, result.UncoveredArea, result.Coverage, result.UnreachableArea,
            [.. result.Unreached.Select(place => new PocketPlaceJson(place.Place.X, place.Place.Y, place.Depth, place.Area))],
            [.. result.TooNarrow.Select(narrow => new PocketNarrowJson(narrow.Place.X, narrow.Place.Y, narrow.Width))],
            depths.Heights,
            [.. pocket.Cuts.Select(StrokeOf)],
            options.Stepover,
            options.PassDistance,
            options.PassOverlap);
    }

    public static void Text(TextWriter output, PocketDrawing pocket, PocketOptions options)
    {
        var result = pocket.Result;
        output.WriteLine(Wording.Get("Pocket.StepoverShown", options.Stepover, options.PassDistance, options.PassOverlap));
        output.WriteLine(Wording.Get("Pocket.Passes", result.Passes.Count, result.Passes.Sum(pass => pass.Segments.Sum(segment => segment.Length)), pocket.Cuts.Count, result.Regions));
        output.WriteLine(result.Coverage is not { } coverage ? Wording.Get("Pocket.NothingReached") : Wording.Get("Pocket.Coverage", 100.0 * coverage, result.ReachableArea, result.UncoveredArea));
        output.WriteLine(Wording.Get("Pocket.Unreached", result.UnreachableArea, result.Unreached.Count));
        foreach (var place in result.Unreached)
        {
            output.WriteLine(place.Area is { } area ? Wording.Get("Pocket.UnreachedPlace", place.Place.X, place.Place.Y, place.Depth, area) : Wording.Get("Pocket.UnreachedPoint", place.Place.X, place.Place.Y, place.Depth));
        }

        output.WriteLine(Wording.Get("Offset.MaxDeviation", result.MaxDeviation));
    }

    private static PocketPassJson PassOf(PocketPass pass)
    {
        var loop = new OffsetLoop(pass.Segments, pass.Closed);
        return new PocketPassJson(pass.Closed, loop.Lines, loop.Arcs, loop.Length, Math.Abs(loop.SignedArea), loop.IsHole, Word(pass.Kind), pass.Level, pass.Region);
    }

    private static PocketStrokeJson StrokeOf(PocketCut cut)
    {
        var moves = cut.Stroke.Moves;
        var links = moves.Where(move => move.IsLink).Sum(move => move.Segment.Length);
        return new PocketStrokeJson(cut.Stroke.Region, cut.Stroke.IsFinish, cut.Z, Word(cut.Entry), cut.Stroke.Start.X, cut.Stroke.Start.Y, cut.Stroke.End.X, cut.Stroke.End.Y, moves.Sum(move => move.Segment.Length) - links, links);
    }

    private static string Word<T>(T value)
        where T : struct, Enum => value.ToString().ToLower(CultureInfo.InvariantCulture);

    /// <param name="Area">Area enclosed by this pass alone, mm2, never negative; 0 when open.</param>
    /// <param name="Hole">The pocket is outside this pass.</param>
    /// <param name="Kind">wall, contour, sliver, row, finish.</param>
    /// <param name="Level">0 at the wall, counted inwards; the number of a row.</param>
    internal sealed record PocketPassJson(bool Closed, int Lines, int Arcs, double Length, double Area, bool Hole, string Kind, int Level, int Region);

    /// <param name="Depth">Distance of the position from the area that the tool reaches, mm.</param>
    /// <param name="Area">mm2; null when unknown.</param>
    internal sealed record PocketPlaceJson(double X, double Y, double Depth, double? Area);

    internal sealed record PocketNarrowJson(double X, double Y, double Width);

    /// <param name="Entry">plunge, ramp, helix.</param>
    internal sealed record PocketStrokeJson(int Region, bool Finish, double Z, string Entry, double StartX, double StartY, double EndX, double EndY, double CutLength, double LinkLength);
}
