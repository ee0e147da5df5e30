using Avalonia.Controls;
using Avalonia.Media.Imaging;
using Engraver.App.Desk;
using Engraver.Workbench.Commands;

namespace Engraver.App.Sessions;

/// <summary>Opens the drawing, runs the script and saves the picture once the window is open.</summary>
public static class DesktopStart
{
    /// <summary>Opens the drawing and runs the script of the options.</summary>
    /// <returns>The sentence of the failure; null on success.</returns>
    public static async Task<string?> OpenAsync(DesktopModel desk, DesktopOptions options)
    {
        if (desk.Session.Settings.Current.LastProfile is { } profile && File.Exists(profile)) await desk.Queue.RunAsync("CNCPROFILE", profile);
        if (options.File is { } file && await desk.Queue.RunAsync("OPEN", file) is InputResult.Failed unopened) return unopened.Message;
        var ran = options.Script is { } script ? await desk.Queue.RunAsync("SCRIPT", script) : null;
        await desk.SettleAsync();
        return ran is InputResult.Failed failed ? failed.Message : null;
    }

    /// <summary>Saves a picture of the window to a file.</summary>
    public static void SavePicture(Window window, double scale, string path)
    {
        using var picture = new RenderTargetBitmap(new Avalonia.PixelSize((int)(window.Bounds.Width * scale), (int)(window.Bounds.Height * scale)), new Avalonia.Vector(96 * scale, 96 * scale));
        picture.Render(window);
        picture.Save(path, PngBitmapEncoderOptions.Default);
    }
}
