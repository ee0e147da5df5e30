namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Takes a path as straight lines. Implemented by structs, so that the walk is compiled for each.</summary>
internal interface IPolylineSink
{
    void MoveTo(double x, double y);

    void LineTo(double x, double y);

    void Close();
}
