using System.Globalization;
using System.Text;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>A document state as text, every number exact: equal text, equal state.</summary>
internal static class Fingerprint
{
    public static string Of(DocumentState state)
    {
        var text = new StringBuilder();
        text.Append(CultureInfo.InvariantCulture, $"{state.Settings with { Layers = null }}|{string.Join(',', state.Selection)}\n");
        if (state.Drawing is not { } drawing) return text.ToString();
        text.AppendJoin(';', drawing.Layers).Append('\n');
        for (var i = 0; i < drawing.Entities.Count; i++)
        {
            var entity = drawing.Entities[i];
            text.Append(CultureInfo.InvariantCulture, $"{entity.Type} {entity.Handle} {entity.FirstPart} {entity.PartCount} {entity.Layer} {entity.Hidden} {entity.Closed}\n");
        }

        for (var i = 0; i < drawing.Parts.Count; i++)
        {
            var part = drawing.Parts[i];
            text.Append(CultureInfo.InvariantCulture, $"{part.Entity} {part.Kind} {part.A:R} {part.B:R} {part.C:R} {part.D:R} {part.E:R} {part.F:R}\n");
        }

        return text.ToString();
    }
}
