using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>A geometry that is written figure by figure.</summary>
internal sealed class SoftwareStreamGeometry : SoftwareGeometry, IStreamGeometryImpl
{
    public SoftwareStreamGeometry()
        : base(new VectorPath())
    {
    }

    private SoftwareStreamGeometry(VectorPath strokePath, VectorPath? fillPath)
        : base(strokePath, fillPath)
    {
    }

    public IStreamGeometryImpl Clone() => new SoftwareStreamGeometry(
        StrokePath.Transformed(Matrix.Identity),
        FillPath == StrokePath ? null : FillPath.Transformed(Matrix.Identity));

    public IStreamGeometryContextImpl Open()
    {
        StrokePath.Clear(FillRule.EvenOdd);
        Rewritten(StrokePath);
        return new GeometryWriter(StrokePath, Rewritten);
    }
}
