using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Tags;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Records;

/// <summary>A number with its group code, for records in which codes repeat (vertices of an LWPOLYLINE).</summary>
internal readonly record struct CodedNumber(int Code, double Value);
