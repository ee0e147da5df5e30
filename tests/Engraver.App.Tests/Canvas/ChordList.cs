using Engraver.App.Canvas.Flattening;
using Engraver.Core.Geometry;

namespace Engraver.App.Tests.Canvas;

/// <summary>Collects chords.</summary>
internal readonly struct ChordList() : IChordSink
{
    public List<LineSegment> Chords { get; } = [];

    public void Chord(double fromX, double fromY, double toX, double toY) => Chords.Add(new LineSegment(new Point2D(fromX, fromY), new Point2D(toX, toY)));

    public double DistanceTo(Point2D place) => Chords.Count == 0 ? double.PositiveInfinity : Chords.Min(chord => chord.DistanceTo(place));
}
