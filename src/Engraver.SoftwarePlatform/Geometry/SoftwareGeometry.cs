using System.Diagnostics.CodeAnalysis;
using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>A path with the queries that Avalonia makes about it. Figures that are not to be filled are only in the stroke path.</summary>
internal class SoftwareGeometry : IGeometryImpl
{
    /// <summary>Largest flattening error for queries about points and lengths, in the geometry's own units.</summary>
    private const double Tolerance = 0.02;

    private Rect? _bounds;
    private ContourLengths? _lengths;

    public SoftwareGeometry(VectorPath path, VectorPath? fillPath = null)
    {
        StrokePath = path;
        FillPath = fillPath ?? path;
    }

    public VectorPath StrokePath { get; }

    public VectorPath FillPath { get; private set; }

    public Rect Bounds => _bounds ??= PathMeasure.Bounds(StrokePath);

    public double ContourLength => Lengths.Total;

    private ContourLengths Lengths => _lengths ??= new ContourLengths(PathFlattener.Flatten(StrokePath, Matrix.Identity, Tolerance));

    public Rect GetRenderBounds(IPen? pen) =>
        pen?.Brush is null || pen.Thickness <= 0 ? Bounds : Bounds.Inflate(PathMeasure.Reach(pen));

    public IGeometryImpl GetWidenedGeometry(IPen pen) => new SoftwareGeometry(Widened(pen));

    public bool FillContains(Point point) => PathMeasure.Contains(FillPath, point, Tolerance);

    public bool StrokeContains(IPen? pen, Point point) => pen is { Thickness: > 0 } && PathMeasure.Contains(Widened(pen), point, Tolerance);

    public IGeometryImpl? Intersect(IGeometryImpl geometry)
    {
        var other = (SoftwareGeometry)geometry;
        if (!Bounds.Intersects(other.Bounds))
            return null;
        return new SoftwareGeometry(PathCombination.Combine(FillPath, other.FillPath, GeometryCombineMode.Intersect));
    }

    public ITransformedGeometryImpl WithTransform(Matrix transform) => new TransformedSoftwareGeometry(this, transform);

    public bool TryGetPointAtDistance(double distance, out Point point) => Lengths.TryFind(distance, out point, out _);

    public bool TryGetPointAndTangentAtDistance(double distance, out Point point, out Point tangent) => Lengths.TryFind(distance, out point, out tangent);

    public bool TryGetSegment(double startDistance, double stopDistance, bool startOnBeginFigure, [NotNullWhen(true)] out IGeometryImpl? segmentGeometry)
    {
        var piece = Lengths.Piece(startDistance, stopDistance);
        segmentGeometry = piece.IsEmpty ? null : new SoftwareGeometry(piece);
        return segmentGeometry is not null;
    }

    /// <summary>To be called after the paths were rewritten.</summary>
    protected void Rewritten(VectorPath fillPath)
    {
        FillPath = fillPath;
        _bounds = null;
        _lengths = null;
    }

    private VectorPath Widened(IPen pen) => Stroker.Stroke(StrokePath, StrokeStyle.From(pen), 1);
}

internal sealed class TransformedSoftwareGeometry(SoftwareGeometry source, Matrix transform)
    : SoftwareGeometry(source.StrokePath.Transformed(transform), TransformedFill(source, transform)), ITransformedGeometryImpl
{
    public IGeometryImpl SourceGeometry => source;

    public Matrix Transform => transform;

    private static VectorPath? TransformedFill(SoftwareGeometry source, Matrix transform) =>
        source.FillPath == source.StrokePath ? null : source.FillPath.Transformed(transform);
}
