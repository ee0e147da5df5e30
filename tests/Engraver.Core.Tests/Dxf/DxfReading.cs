using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Short methods to read a drawing and to compare its content.</summary>
internal static class DxfReading
{
    public static Drawing Of(byte[] file, DxfReadOptions? options = null) => DxfReader.Read(file, "test.dxf", options ?? DxfReadOptions.Default, CancellationToken.None);

    public static Drawing Of(string text) => Of(Encoding.UTF8.GetBytes(text));

    public static Drawing Of(DxfText text) => Of(text.ToAscii());

    public static Drawing Entities(params ReadOnlySpan<(int Code, object Value)> pairs) => Of(DxfText.WithEntities(pairs));

    public static DrawingPart[] Parts(Drawing drawing) => [.. Enumerable.Range(0, drawing.Parts.Count).Select(i => drawing.Parts[i])];

    public static DrawingEntity[] Curves(Drawing drawing) => [.. Enumerable.Range(0, drawing.Entities.Count).Select(i => drawing.Entities[i])];

    public static string[] Ids(Drawing drawing) => [.. drawing.Diagnostics.Select(diagnostic => diagnostic.Id)];

    /// <summary>Everything that two readings of one drawing must have in common, without lines and byte offsets.</summary>
    public static string Fingerprint(Drawing drawing)
    {
        var text = new StringBuilder();
        foreach (var entity in Curves(drawing)) text.Append(CultureInfo.InvariantCulture, $"{entity.Type} {entity.Handle:X} {entity.PartCount} {drawing.Layers[entity.Layer].Name} {entity.Hidden} {entity.Closed}\n");
        foreach (var part in Parts(drawing)) text.Append(CultureInfo.InvariantCulture, $"{part.Kind} {part.A:R} {part.B:R} {part.C:R} {part.D:R} {part.E:R} {part.F:R}\n");
        text.AppendJoin(' ', Ids(drawing)).Append(CultureInfo.InvariantCulture, $"\n{drawing.Balance.Read} {drawing.Balance.Cut} {drawing.Balance.Construction} {drawing.Balance.Refused.Count}");
        return text.ToString();
    }
}
