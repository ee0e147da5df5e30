namespace Engraver.App.Canvas.Flattening;

/// <summary>Takes the straight pieces that a curve is drawn with, pixels.</summary>
internal interface IChordSink
{
    void Chord(double fromX, double fromY, double toX, double toY);
}
