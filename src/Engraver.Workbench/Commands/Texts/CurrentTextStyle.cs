using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>The style of new texts: the one chosen last, otherwise Standard.</summary>
internal static class CurrentTextStyle
{
    public const string DefaultName = "Standard";

    /// <summary>File name of the stroke font of this program.</summary>
    public const string OwnFont = "engraver";

    /// <param name="state">Its drawing must be open.</param>
    public static TextStyle Of(DocumentState state) => Find(state.Drawing!, state.CurrentStyle) ?? Find(state.Drawing!, DefaultName) ?? new TextStyle(DefaultName) { FontFile = OwnFont };

    /// <summary>The style of a name in any case; null if the drawing has none.</summary>
    public static TextStyle? Find(Drawing drawing, string name) => drawing.Styles.FirstOrDefault(style => style.Name.Equals(name, StringComparison.OrdinalIgnoreCase));
}
