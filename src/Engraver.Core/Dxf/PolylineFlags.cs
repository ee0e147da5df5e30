namespace Engraver.Core.Dxf;

/// <summary>Group 70 of POLYLINE and VERTEX.</summary>
internal static class PolylineFlags
{
    public const int Closed = 1;

    /// <summary>A 3D polyline: vertices in world coordinates, no bulges.</summary>
    public const int InSpace = 8;

    /// <summary>A polygon mesh (16) or a polyface mesh (64).</summary>
    public const int Mesh = 16 | 64;

    /// <summary>On a VERTEX: control point of a spline frame, not drawn.</summary>
    public const int FrameVertex = 16;
}
