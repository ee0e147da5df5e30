using Avalonia;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Geometry;

internal sealed class TransformedSoftwareGeometry(SoftwareGeometry source, Matrix transform)
    : SoftwareGeometry(source.StrokePath.Transformed(transform), TransformedFill(source, transform)), ITransformedGeometryImpl
{
    public IGeometryImpl SourceGeometry => source;

    public Matrix Transform => transform;

    private static VectorPath? TransformedFill(SoftwareGeometry source, Matrix transform) =>
        source.FillPath == source.StrokePath ? null : source.FillPath.Transformed(transform);
}
