using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>The entering entity of paper 000: the stroke that is cut first. (What lies inside it is cut before it all the same.)</summary>
public abstract record EnterAt
{
    private EnterAt()
    {
    }

    /// <summary>The stroke that holds this drawing entity, started at the entity where that is possible: at any of a closed stroke's joints, at an open one's ends.</summary>
    public sealed record AtEntity(int EntityIndex) : EnterAt;

    /// <summary>The stroke with the start point nearest to this place (millimetres), started there.</summary>
    public sealed record AtPlace(Point2D Place) : EnterAt;
}
