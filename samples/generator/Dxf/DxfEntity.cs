namespace Engraver.Samples.Dxf;

/// <summary>A drawn thing, before it is written in the manner of one DXF version.</summary>
internal abstract record DxfEntity(string Layer)
{
    /// <summary>The same drawn thing from its other end; itself where the file format has no direction to give.</summary>
    public virtual DxfEntity Reversed() => this;
}
