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

    /// <summary>More layers of the drawing are not named.</summary>
    private const int MaxLayers = 20;

    public static SettingException UnknownLayers(IReadOnlyList<string> unknown, IReadOnlyList<Layer> layers)
    {
        var (missing, known) = (Quoted(unknown), Quoted(layers.Take(MaxLayers).Select(layer => layer.Name)));
        return new(layers.Count > MaxLayers ? Wording.Get("SettingException.LayerNotFoundOfMany", missing, known, MaxLayers) : Wording.Get("SettingException.LayerNotFound", missing, known));
    }

    public static SettingException UnknownHandle(string handle) => new(Wording.Get("SettingException.HandleNotFound", handle));

    private static string Quoted(IEnumerable<string> names) => string.Join(", ", names.Select(name => $"'{name}'"));
}
