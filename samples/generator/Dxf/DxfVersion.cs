namespace Engraver.Samples.Dxf;

/// <summary>The file versions that the samples are spread over.</summary>
internal enum DxfVersion
{
    /// <summary>AC1009: no handles, no subclass markers, POLYLINE with VERTEX.</summary>
    R12,

    /// <summary>AC1015: handles, subclass markers, LWPOLYLINE.</summary>
    R2000,

    /// <summary>AC1032: as R2000, text in UTF-8.</summary>
    R2018,
}
