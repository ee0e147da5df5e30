namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>Where the tool enters and leaves a node, millimetres.</summary>
internal readonly record struct NodeEnds(double InX, double InY, double OutX, double OutY)
{
    /// <summary>The node in the other direction.</summary>
    public NodeEnds Turned => new(OutX, OutY, InX, InY);
}
