namespace Engraver.Samples.Dxf;

/// <summary>Takes the (group code, value) pairs that every DXF file is made of. The seam between the two file forms.</summary>
internal interface ITagSink
{
    void Text(int code, string value);

    void Real(int code, double value);

    void Integer(int code, int value);
}
