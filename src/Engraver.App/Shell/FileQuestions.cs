using Avalonia.Platform.Storage;
using Engraver.App.Desk;
using Engraver.App.Texts;

namespace Engraver.App.Shell;

/// <summary>A command that was clicked and asks for a file at once gets a file dialog; typed, it takes the name from the command line.</summary>
/// <param name="dialogs">Where dialogs come from.</param>
public sealed class FileQuestions(DesktopModel desk, Func<IStorageProvider> dialogs)
{
    private static readonly Dictionary<string, string[]> s_toRead = new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["OPEN"] = ["*.dxf"],
        ["SCRIPT"] = ["*.scr"],
        ["CNCPROFILE"] = ["*.json"],
        ["VERIFY"] = ["*.dmc"],
        ["SEND"] = ["*.agie", "*.dmc", "*.ngc", "*.nc", "*.txt"],
    };

    private static readonly Dictionary<string, string[]> s_toWrite = new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["SAVEAS"] = ["*.dxf"],
        ["EXPORT"] = ["*.svg", "*.csv", "*.json", "*.dmc", "*.dxf"],
    };

    /// <summary>True when the system variable FILEDIA is not 0.</summary>
    public bool WantsDialogs => desk.Session.Settings.Current.Variables.GetValueOrDefault("FILEDIA", 1.0) != 0.0;

    public async Task RunAsync(string command)
    {
        await desk.RunAsync(command);
        if (!WantsDialogs || desk.Prompt.Command != command) return;
        if (s_toRead.TryGetValue(command, out var read) && dialogs().CanOpen) await AnswerAsync(command, await ToReadAsync(command, read));
        else if (s_toWrite.TryGetValue(command, out var write) && dialogs().CanSave) await AnswerAsync(command, await ToWriteAsync(command, write));
    }

    /// <summary>Answers the command with a file, unless it was answered or ended meanwhile.</summary>
    private async Task AnswerAsync(string command, IStorageItem? file)
    {
        if (desk.Prompt.Command != command) return;
        if (file?.TryGetLocalPath() is { } path) await desk.EnterAsync(path);
        else await desk.CancelAsync();
    }

    private async Task<IStorageItem?> ToReadAsync(string command, string[] patterns)
    {
        var files = await dialogs().OpenFilePickerAsync(new FilePickerOpenOptions { Title = Text.Get("Command." + command), FileTypeFilter = TypesOf(patterns) });
        return files is [var file, ..] ? file : null;
    }

    /// <summary>Asks for a file to write. The dialog does not ask whether to replace one, because the command does.</summary>
    private async Task<IStorageItem?> ToWriteAsync(string command, string[] patterns) => await dialogs().SaveFilePickerAsync(new FilePickerSaveOptions
    {
        Title = Text.Get("Command." + command),
        FileTypeChoices = TypesOf(patterns),
        DefaultExtension = patterns[0][2..],
        SuggestedFileName = Path.GetFileNameWithoutExtension(desk.Session.Document.FilePath),
        ShowOverwritePrompt = false,
    });

    private static IReadOnlyList<FilePickerFileType> TypesOf(string[] patterns) =>
        [.. patterns.Select(pattern => new FilePickerFileType(pattern) { Patterns = [pattern] }), new FilePickerFileType(Text.Get("Files.All")) { Patterns = ["*"] }];
}
