namespace Engraver.Core.Dxf.Records;

/// <summary>A number with its group code, for records in which codes repeat (vertices of an LWPOLYLINE).</summary>
internal readonly record struct CodedNumber(int Code, double Value);
