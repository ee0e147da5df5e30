namespace Engraver.App.Canvas.Flattening;

/// <summary>Receives the chords with which a curve is drawn, pixels.</summary>
internal interface IChordSink
{
    void Chord(double fromX, double fromY, double toX, double toY);
}
