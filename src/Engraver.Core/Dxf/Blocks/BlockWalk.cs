using System.Runtime.InteropServices;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Visits every copy of a block and of the blocks nested in it, in drawing order. Uses its own stack, so that nesting may be of any depth.</summary>
internal sealed class BlockWalk(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, BlockPathTable paths, IBlockVisitor visitor, CancellationToken cancellation)
{
    private readonly List<BlockVisit> _open = [];

    /// <summary>Visits an insert of model space; the weight of its block is known.</summary>
    public void Through(in BlockInsert insert, BlockDefinition block)
    {
        Open(insert, block, Placement.Identity, InsertStyle.FromModelSpace(insert, paths));
        while (_open.Count > 0)
        {
            ref var visit = ref CollectionsMarshal.AsSpan(_open)[^1];
            if (visit.Nested < visit.Block.Inserts.Count) Nested(ref visit);
            else Leave(ref visit);
        }
    }

    private void Open(in BlockInsert insert, BlockDefinition block, in Placement outer, InsertStyle style)
    {
        cancellation.ThrowIfCancellationRequested();
        style = style with { Hidden = style.Hidden || insert.Invisible || layers.IsFrozen(style.Layer) };
        var visit = new BlockVisit { Insert = insert, Block = block, Outer = outer, Style = style, Around = style.Insert };
        Begin(ref visit);
        _open.Add(visit);
    }

    private void Begin(ref BlockVisit visit)
    {
        var insert = visit.Insert;
        visit.At = visit.Outer.After(insert.Copy((int)(visit.Copy % insert.Columns), (int)(visit.Copy / insert.Columns), visit.Block.BasePoint));
        (visit.Curve, visit.Nested) = (visit.Block.FirstCurve, 0);
        visit.Style = visit.Style with { Insert = visitor.Enter(visit.Block, visit.At, visit.Style, visit.Around) };
    }

    /// <summary>Draws up to the next nested insert and enters that. The visit must not be used afterwards: the list may have been reallocated.</summary>
    private void Nested(ref BlockVisit visit)
    {
        var nested = visit.Block.Inserts[visit.Nested++];
        Draw(ref visit, nested.BeforeCurve);
        if (nested.Obstacle is null && blocks[nested.Insert.Block] is var child && visitor.ShouldVisit(child.Weight!)) Open(nested.Insert, child, visit.At, visit.Style.Inside(nested.Insert, layers, paths));
    }

    private void Leave(ref BlockVisit visit)
    {
        Draw(ref visit, visit.Block.EndCurve);
        if (++visit.Copy < visit.Insert.Copies) Begin(ref visit);
        else _open.RemoveAt(_open.Count - 1);
    }

    private void Draw(ref BlockVisit visit, int end)
    {
        if (visit.Curve < end) visitor.Curves(visit.Curve, end, visit.At, visit.Style);
        visit.Curve = end;
    }

    /// <summary>An insert that is being visited.</summary>
    private struct BlockVisit
    {
        public BlockInsert Insert;
        public BlockDefinition Block;
        public Placement Outer;
        public InsertStyle Style;

        /// <summary>Number of the insert in which it is nested; 0 for none.</summary>
        public int Around;

        /// <summary>Number of the copy in an array, row by row, from 0.</summary>
        public long Copy;
        public Placement At;

        /// <summary>The next curve of this copy.</summary>
        public int Curve;

        /// <summary>The next nested insert of this copy.</summary>
        public int Nested;
    }
}

/// <summary>Receives the visits of a <see cref="BlockWalk"/>.</summary>
internal interface IBlockVisitor
{
    /// <summary>False to skip a block and everything nested in it.</summary>
    bool ShouldVisit(BlockWeight weight);

    /// <summary>Called at the beginning of a copy of a block.</summary>
    /// <param name="around">Number of the copy in which it is nested; 0 for none.</param>
    /// <returns>The number of this copy; 0 from a visitor that does not number them.</returns>
    int Enter(BlockDefinition block, in Placement at, in InsertStyle style, int around);

    /// <summary>Curves of the copy, in order; the inserts between them are visited between two calls.</summary>
    void Curves(int first, int end, in Placement at, in InsertStyle style);
}
