using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>The entering entity of paper 000: the stroke that is cut first. (Strokes inside it are still cut before it.)</summary>
public abstract record EntryRequest
{
    private EntryRequest()
    {
    }

    /// <summary>The stroke that contains this drawing entity, started at the entity where that is possible: at any joint of a closed stroke, at the ends of an
    /// open stroke.</summary>
    public sealed record AtEntity(int EntityIndex) : EntryRequest;

    /// <summary>The stroke with the start point nearest to this point (millimetres), started there; a circle may start at any of its points.</summary>
    public sealed record AtPlace(Point2D Place) : EntryRequest;
}
