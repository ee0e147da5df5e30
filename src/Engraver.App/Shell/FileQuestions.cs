using Avalonia.Controls;
using Avalonia.Platform.Storage;
using Engraver.App.Desk;
using Engraver.App.Texts;

namespace Engraver.App.Shell;

/// <summary>A command that was clicked and asks for a file to read gets a file dialog; typed, it takes the name from the command line.</summary>
public sealed class FileQuestions(WorkDesk desk, TopLevel window)
{
    private static readonly Dictionary<string, string> s_patterns = new Dictionary<string, string>(StringComparer.Ordinal)
    {
        ["OPEN"] = "*.dxf",
        ["SCRIPT"] = "*.scr",
        ["CNCPROFILE"] = "*.json",
    };

    /// <summary>FILEDIA.</summary>
    public bool WantsDialogs => desk.Session.Settings.Current.Variables.GetValueOrDefault("FILEDIA", 1.0) != 0.0;

    public async Task RunAsync(string command)
    {
        await desk.RunAsync(command);
        if (!WantsDialogs || !s_patterns.TryGetValue(command, out var pattern) || desk.Prompt.Command != command || !window.StorageProvider.CanOpen) return;
        var files = await window.StorageProvider.OpenFilePickerAsync(OptionsFor(command, pattern));
        if (desk.Prompt.Command != command) return;
        if (files is [var file, ..] && file.TryGetLocalPath() is { } path) await desk.FeedAsync(path);
        else await desk.CancelAsync();
    }

    private static FilePickerOpenOptions OptionsFor(string command, string pattern) => new()
    {
        Title = Text.Of("Command." + command),
        FileTypeFilter = [new FilePickerFileType(pattern) { Patterns = [pattern] }, new FilePickerFileType(Text.Of("Files.All")) { Patterns = ["*"] }],
    };
}
