using System.Globalization;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf.Writing;

/// <summary>An entity has a number that is not finite and therefore cannot be stored in a DXF: no part of the drawing may be written. Its message is the
/// reason, without a full stop.</summary>
public sealed class UnwritableEntityException : IOException
{
    public UnwritableEntityException(SourceRef source)
        : base(Wording.Get("DxfWriter.NotFinite", NameOf(source))) => Source = source;

    /// <summary>The entity as read; default where it is a text or a point.</summary>
    public new SourceRef Source { get; }

    /// <summary>Its handle, or its line where it has none.</summary>
    public static string NameOf(SourceRef source) =>
        source.Handle ?? (source.Line > 0 ? Wording.Get("DxfWriter.AtLine", source.Line.ToString(CultureInfo.InvariantCulture)) : Wording.Get("DxfWriter.WithoutHandle"));
}
