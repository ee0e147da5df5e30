namespace Engraver.Core.Machines;

public enum VectorSegmentKind : byte
{
    /// <summary>VP x,y.</summary>
    Line,

    /// <summary>CR radius,theta,delta.</summary>
    Arc,
}
