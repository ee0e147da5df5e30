namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Receives a path as straight lines. Implemented by structs, so that the code is compiled for each.</summary>
internal interface IPolylineSink
{
    void MoveTo(double x, double y);

    void LineTo(double x, double y);

    void Close();
}
