using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>Plans the passes that clear the inside of closed contours with islands.</summary>
/// <remarks>Passes are exact lines and arcs. The covered area is computed again from the passes themselves (<see cref="SweptArea"/>), independently of how they
/// were planned.</remarks>
public static class PocketPlanner
{
    /// <summary>Fraction of the reachable area up to which a difference counts as rounding.</summary>
    private const double AreaRounding = 1e-7;

    /// <summary>Distance from the boundary of the reachable area beyond which material counts as left, millimetres.</summary>
    private const double MinReportedDepth = 1e-5;

    /// <param name="contours">The drawn contours; open contours have no inside and are only counted.</param>
    /// <param name="options">Tool and strategy.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is not above 0, the stepover not between 0 and 1, the allowance not between 0 and the
    /// radius.</exception>
    public static PocketResult Plan(IReadOnlyList<OffsetContour> contours, PocketOptions options)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(options.ToolRadius);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(options.Stepover);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(options.Stepover, 1.0);
        ArgumentOutOfRangeException.ThrowIfNegative(options.Allowance);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(options.Allowance, options.ToolRadius);
        var offset = OffsetOptions.Round(options.MaxErrorMm);
        var (regions, unresolved) = PocketRegions.Of(contours, offset, options.JoinToleranceMm);
        var plans = regions.Select((region, number) => RegionPlan.Of(region, number, options, offset)).ToList();
        return new PocketResult
        {
            Passes = [.. plans.SelectMany(plan => plan.Passes)],
            Strokes = [.. plans.SelectMany(plan => plan.Strokes)],
            DrawnArea = regions.Sum(region => region.Area),
            ReachableArea = plans.Sum(plan => plan.ReachableArea),
            CoveredArea = plans.Sum(plan => plan.CoveredArea),
            Unreached = [.. plans.SelectMany(plan => plan.Unreached)],
            LeftStanding = [.. plans.SelectMany(plan => plan.LeftStanding)],
            TooNarrow = [.. plans.Select(plan => plan.Narrow).OfType<NarrowRegion>()],
            Unresolved = [.. unresolved, .. plans.SelectMany(plan => plan.Depths.Unresolved)],
            MaxDeviation = plans.Count == 0 ? 0.0 : plans.Max(plan => plan.Depths.MaxDeviation),
            WithoutInside = contours.Count(contour => !contour.Closed),
            Regions = regions.Count,
            Walls = [.. regions.Select(region => region.Walls)],
        };
    }

    /// <summary>Passes and strokes of one region.</summary>
    private sealed class RegionPlan(PocketRegion region, int number, PocketOptions options, OffsetOptions offset)
    {
        private readonly LinkCheck _check = new(region, options);
        private List<PassChain> _chains = [];
        private List<PassChain> _finish = [];

        public RegionDepths Depths { get; } = new(region, offset);

        public List<PocketPass> Passes { get; } = [];

        public List<PocketStroke> Strokes { get; } = [];

        public double ReachableArea { get; private set; }

        public double CoveredArea { get; private set; }

        public List<UnreachedPlace> Unreached { get; private set; } = [];

        public List<Point2D> LeftStanding { get; private set; } = [];

        public NarrowRegion? Narrow { get; private set; }

        public static RegionPlan Of(PocketRegion region, int number, PocketOptions options, OffsetOptions offset)
        {
            var plan = new RegionPlan(region, number, options, offset);
            plan.Run();
            return plan;
        }

        private void Run()
        {
            var (loops, passes) = Depths.AtRadius(options.ToolRadius);
            if (loops.Count == 0)
            {
                Narrow = Depths.Widest(options.ToolRadius);
                return;
            }

            var reached = ContourOffset.Offset([.. loops.Select(loop => new OffsetContour([.. loop.Select(piece => piece.ToSegment())], true))], options.ToolRadius, OffsetSide.Out, offset);
            Depths.Unresolved.AddRange(reached.Unresolved);
            ReachableArea = reached.Loops.Sum(loop => loop.SignedArea);
            Unreached = UnreachableMaterial.Find(region.Walls, loops, reached.Loops, options.ToolRadius);
            if (options.Allowance > 0.0) _finish = [.. passes.Select(loop => new PassChain(loop, loop[^1].End == loop[0].Start, PassKind.Finish, 0))];
            var wall = options.Allowance > 0.0 ? Depths.At(options.ToolRadius + options.Allowance) : passes;
            if (options.Strategy == PocketStrategy.Zigzag) PlanRows(wall);
            else PlanContours(wall);
            Measure(reached.Loops);
            AddStrokes([.. _finish.Select(Alone)], isFinish: true);
            foreach (var chain in _chains.Concat(_finish)) Passes.Add(new PocketPass([.. chain.Pieces.Select(piece => piece.ToSegment())], chain.Closed, chain.Kind, chain.Level, number));
        }

        private void PlanRows(List<PathPiece[]> wall)
        {
            List<PassChain> walls = [.. wall.Select(loop => new PassChain(loop, loop[^1].End == loop[0].Start, PassKind.Wall, 0))];
            var rows = ZigzagRows.Of(Depths, options);
            _chains = [.. walls, .. rows.Rows.Select(row => new PassChain([row.Piece], false, PassKind.Row, row.Row))];
            AddStrokes(ZigzagTour.Strokes(walls, rows, _check, options), isFinish: false);
        }

        private void PlanContours(List<PathPiece[]> wall)
        {
            var levels = ContourPasses.Of(Depths, wall, options);
            List<PassChain> parallel = [.. levels.Levels.SelectMany(level => level)];
            _chains = [.. parallel, .. levels.Slivers(generous: false)];
            if (options.PassDistance > options.ToolRadius && Sweep().Area < ReachableArea * (1.0 - AreaRounding)) _chains = [.. parallel, .. levels.Slivers(generous: true)];
            if (_chains.Count > 0) AddStrokes(ContourTour.Strokes(_chains, _check, options.FromCentre), isFinish: false);
        }

        private SweptArea Sweep() => SweptArea.Of([.. _chains.Concat(_finish).Select(chain => chain.Pieces)], options.ToolRadius);

        /// <summary>Area and, when material is left, its boundary: the part of the boundary of the swept area that is not the boundary of the reachable
        /// area.</summary>
        private void Measure(IReadOnlyList<OffsetLoop> reached)
        {
            var swept = Sweep();
            CoveredArea = swept.Area;
            if (CoveredArea >= ReachableArea * (1.0 - AreaRounding)) return;
            var border = new SweptReach([.. reached.SelectMany(loop => loop.Segments).Select(segment => PathPiece.FromSegment(segment))], options.ToolRadius);
            LeftStanding = [.. swept.Border.Select(part => part.PointAt(0.5)).Where(place => border.Distance(place) > MinReportedDepth)];
        }

        private static List<(PathPiece Piece, bool IsLink)> Alone(PassChain chain)
        {
            var pieces = new List<PathPiece>();
            if (chain.Closed) chain.AddForwards(chain.Middle, chain.Middle, pieces);
            else pieces.AddRange(chain.Pieces);
            return [.. pieces.Select(piece => (piece, false))];
        }

        private void AddStrokes(List<List<(PathPiece Piece, bool IsLink)>> strokes, bool isFinish)
        {
            foreach (var moves in strokes) Strokes.Add(new PocketStroke([.. moves.Select(move => new PocketMove(move.Piece.ToSegment(), move.IsLink))], number, isFinish));
        }
    }
}
