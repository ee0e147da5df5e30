namespace Engraver.Core.Dxf;

/// <summary>Takes what a <see cref="BlockWalk"/> comes by.</summary>
internal interface IBlockVisitor
{
    /// <summary>False for a block of which nothing is wanted, with all that is nested in it.</summary>
    bool Wants(BlockWeight weight);

    /// <summary>A copy of a block begins.</summary>
    void Enter(Block block, in Placement at, in InsertStyle style);

    /// <summary>Curves of the copy, in their order; between two calls come the inserts that stand between them.</summary>
    void Curves(int first, int end, in Placement at, in InsertStyle style);
}
