using System.Globalization;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Languages;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Settings;

/// <summary>The settings of the desktop as a JSON file. Written whole or not at all; a file that cannot be understood is set aside under another name,
/// never lost.</summary>
public static class SettingsFile
{
    /// <summary>The settings, and a sentence when the file could not be used. A file that is not there is the first start and no finding.</summary>
    public static (DesktopSettings Settings, string? Finding) Load(string path, TimeProvider time)
    {
        try
        {
            var read = File.Exists(path) ? JsonSerializer.Deserialize(File.ReadAllText(path), DesktopSettingsJson.Default.DesktopSettings) : DesktopSettings.Default;
            return read is null ? MoveAside(path, Wording.Get("SettingsFile.Empty"), time) : (Checked(read), null);
        }
        catch (JsonException broken)
        {
            return MoveAside(path, SystemErrorText.FromException(broken), time);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return (DesktopSettings.Default, Wording.Get("SettingsFile.CannotRead", path, SystemErrorText.FromException(unreadable)));
        }
    }

    /// <exception cref="IOException">The place cannot be written; what was there is still there.</exception>
    /// <exception cref="UnauthorizedAccessException">The same.</exception>
    public static void Save(string path, DesktopSettings settings)
    {
        if (Path.GetDirectoryName(path) is { Length: > 0 } folder) Directory.CreateDirectory(folder);
        OutputFile.Write(path, output => output.WriteLine(JsonSerializer.Serialize(settings, DesktopSettingsJson.Default.DesktopSettings)));
    }

    private static (DesktopSettings Settings, string? Finding) MoveAside(string path, string why, TimeProvider time)
    {
        var aside = string.Create(CultureInfo.InvariantCulture, $"{path}.broken-{time.GetUtcNow():yyyyMMdd-HHmmss-fff}");
        try
        {
            File.Move(path, aside);
            return (DesktopSettings.Default, Wording.Get("SettingsFile.Invalid", path, why, aside));
        }
        catch (Exception stuck) when (stuck is IOException or UnauthorizedAccessException)
        {
            return (DesktopSettings.Default, Wording.Get("SettingsFile.InvalidNotRenamed", path, why, SystemErrorText.FromException(stuck)));
        }
    }

    /// <summary>The settings with their defaults where JSON says null, and with window sizes and scales in their ranges.</summary>
    private static DesktopSettings Checked(DesktopSettings read) => read with
    {
        RecentFiles = [.. (read.RecentFiles ?? []).OfType<string>().Take(DesktopSettings.MaxRecentFiles)],
        FileFolders = read.FileFolders ?? DesktopSettings.Default.FileFolders,
        PanelSizes = read.PanelSizes ?? DesktopSettings.Default.PanelSizes,
        FoldedPanels = read.FoldedPanels ?? [],
        PanelsOpenWhenSmall = read.PanelsOpenWhenSmall ?? [],
        Variables = read.Variables ?? DesktopSettings.Default.Variables,
        Views = read.Views ?? DesktopSettings.Default.Views,
        Scale = InRangeOr(read.Scale, 0.5, 4.0, 1.0),
        WindowWidth = InRangeOr(read.WindowWidth, 320.0, 20000.0, 1280.0),
        WindowHeight = InRangeOr(read.WindowHeight, 240.0, 20000.0, 800.0),
    };

    private static double InRangeOr(double value, double min, double max, double otherwise) => value >= min && value <= max ? value : otherwise;
}

[JsonSourceGenerationOptions(WriteIndented = true, PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, UseStringEnumConverter = true)]
[JsonSerializable(typeof(DesktopSettings))]
internal sealed partial class DesktopSettingsJson : JsonSerializerContext;
