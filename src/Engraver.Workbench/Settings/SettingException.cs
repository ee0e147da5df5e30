using Engraver.Core.Drawings;

namespace Engraver.Workbench.Settings;

/// <summary>A setting that can be read but does not fit the drawing: an unknown layer, an unknown handle. The message says what there is instead.</summary>
public sealed class SettingException : Exception
{
    public SettingException()
    {
    }

    public SettingException(string message)
        : base(message)
    {
    }

    public SettingException(string message, Exception inner)
        : base(message, inner)
    {
    }

    public static SettingException UnknownLayers(IReadOnlyList<string> unknown, IReadOnlyList<Layer> layers) => new(
        Wording.Get("SettingException.DrawingHasNoLayer", string.Join(", ", unknown.Select(name => $"'{name}'")), string.Join(", ", layers.Take(20).Select(layer => $"'{layer.Name}'")), layers.Count > 20 ? Wording.Get("SettingException.Others") : ""));

    public static SettingException UnknownHandle(string handle) => new(Wording.Get("SettingException.EnterNoCurveDrawing", handle));
}
