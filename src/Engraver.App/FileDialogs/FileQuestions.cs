using Avalonia.Threading;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.App.FileDialogs;

/// <summary>Shows the file dialog whenever a command asks for a file and the system variable FILEDIA is not 0, whether the command was clicked or typed; a
/// script and pasted lines answer by themselves. Asks before a file is replaced and before edits are lost, also by closing the window.</summary>
public sealed class FileQuestions : Observable
{
    private readonly DesktopModel _desk;
    private readonly Func<string> _typed;
    private FileWanted? _asked;
    private bool _isLooking;

    /// <param name="typed">Takes what was typed at the command line after the command: it belongs to the name.</param>
    public FileQuestions(DesktopModel desk, Func<string> typed)
    {
        (_desk, _typed) = (desk, typed);
        Dialog = new FileDialogModel(desk);
        Dialog.Answered += choice => _ = AnswerAsync(choice);
        Dialog.Left += Abandon;
        desk.Notifications.Changed += LookSoon;
    }

    /// <summary>Raised when what was asked for could not be done; the command window says why.</summary>
    public event Action? Refused;

    public FileDialogModel Dialog { get; }

    public QuestionModel Question { get; } = new();

    /// <summary>True when the system variable FILEDIA is not 0.</summary>
    public bool WantsDialogs => _desk.Session.Settings.Current.Variables.GetValueOrDefault("FILEDIA", 1.0) != 0.0;

    /// <summary>Nothing is looked for in the background, and the dialog is what the prompt asks for.</summary>
    internal bool IsAtRest => !_isLooking && !Dialog.IsWorking;

    /// <summary>Opens a drawing that was dropped, or chosen from a list: edits of the one that is open are asked about first.</summary>
    public async Task OpenAsync(string path)
    {
        if (!await MayLoseEditsAsync("Files.Edited", "Files.OpenAnyway")) return;
        Remember(FileWanted.Drawing, path);
        await TellAsync(_desk.Queue.RunAsync("OPEN", TypedFileName.Write(path)));
    }

    /// <summary>Asks about edits before the window closes. A question that stands already is left for this one.</summary>
    /// <returns>False when the window stays: the operator wants it, or the edits could not be saved.</returns>
    public Task<bool> MayCloseAsync() => MayLoseEditsAsync("Files.EditedClose", "Files.DoNotSave");

    /// <summary>Runs a script that was dropped.</summary>
    public Task RunScriptAsync(string path) => TellAsync(_desk.Queue.RunAsync("SCRIPT", TypedFileName.Write(path)));

    private async Task TellAsync(Task<InputResult> work)
    {
        if (await work is InputResult.Failed or InputResult.NotUnderstood) Refused?.Invoke();
    }

    /// <summary>Looks once the present input is through: a prompt that is answered by the next input of a script is none for a dialog.</summary>
    private void LookSoon()
    {
        if (_isLooking) return;
        _isLooking = true;
        Dispatcher.UIThread.Post(Look, DispatcherPriority.Input);
    }

    private void Look()
    {
        _isLooking = false;
        var wanted = _desk.Prompt.File;
        if (_asked is not null && !ReferenceEquals(wanted, _asked)) Leave();
        if (wanted is null || _asked is not null || !WantsDialogs || _desk.Queue.IsBusy || !_desk.Queue.Idle.IsCompleted) return;
        _asked = wanted;
        Dialog.Open(wanted, Text.Find("Command." + _desk.Prompt.Command) ?? _desk.Prompt.Command!, _typed());
    }

    private void Leave()
    {
        _asked = null;
        Dialog.Close();
        Question.Leave();
    }

    private void Abandon()
    {
        Dialog.Close();
        _ = _desk.Queue.CancelAsync();
    }

    /// <summary>Answers the command. The dialog goes at once: what is typed from now on is for the command line.</summary>
    private Task AnswerNowAsync(FileWanted wanted, string? path)
    {
        Dialog.Close();
        return TellAsync(_desk.Queue.AnswerFileAsync(wanted, path is null ? null : AsTyped(path)));
    }

    /// <summary>The path as somebody would type it: a file in the working folder by its name alone. A journal of inputs then runs in another place
    /// too.</summary>
    private string AsTyped(string path)
    {
        var name = Path.GetRelativePath(_desk.Session.Folder, path);
        return Path.IsPathRooted(name) || name.StartsWith("..", StringComparison.Ordinal) ? path : name;
    }

    /// <param name="choice">Null: the result is shown in the command window.</param>
    private async Task AnswerAsync(FileChoice? choice)
    {
        if (_asked is not { } wanted) return;
        if (choice is null)
        {
            await AnswerNowAsync(wanted, null);
            return;
        }

        if (wanted.Writes && choice.Exists && !await MayReplaceAsync(choice.Path)) return;
        if (wanted is { Kind: FileWanted.Drawing, Writes: false })
        {
            if (await AskAboutEditsAsync("Files.Edited", "Files.OpenAnyway") is not { } saves || !ReferenceEquals(_asked, wanted)) return;
            Remember(wanted.Kind, choice.Path);
            if (saves) await SaveAndOpenAsync(choice.Path);
            else await AnswerNowAsync(wanted, choice.Path);
            return;
        }

        if (!ReferenceEquals(_asked, wanted)) return;
        Remember(wanted.Kind, choice.Path);
        await AnswerNowAsync(wanted, choice.Path);
    }

    /// <summary>The dialog begins in the folder that was used last.</summary>
    private void Remember(string kind, string path) => _desk.Session.Settings.Change(settings => settings.WithFileFolder(kind, Path.GetDirectoryName(Path.GetFullPath(path))!));

    private async Task<bool> MayReplaceAsync(string path) =>
        await Question.AskAsync(Text.Get("Files.Replace", Path.GetFileName(path), Path.GetDirectoryName(path)), "Files.No", "Files.Yes") == "Files.Yes";

    private async Task SaveAndOpenAsync(string path)
    {
        Dialog.Close();
        if (await SaveAsync()) await TellAsync(_desk.Queue.RunAsync("OPEN", TypedFileName.Write(path)));
        else Refused?.Invoke();
    }

    /// <returns>False when it could not be saved; also for a new drawing, whose file the dialog asks for now: what should come afterwards is asked for
    /// again.</returns>
    private async Task<bool> SaveAsync() => (_desk.Session.Document.HasFile ? await _desk.Queue.RunAsync("QSAVE", "Yes") : await _desk.Queue.RunAsync("QSAVE")) is InputResult.Done;

    /// <returns>False when the operator wants to keep the drawing open, or it could not be saved.</returns>
    private async Task<bool> MayLoseEditsAsync(string question, string without)
    {
        if (await AskAboutEditsAsync(question, without) is not { } saves) return false;
        if (!saves || await SaveAsync()) return true;
        Refused?.Invoke();
        return false;
    }

    /// <summary>Asks whether edits that are in no file are saved first.</summary>
    /// <param name="question">Name of the text; it says what would lose them.</param>
    /// <param name="without">Name of the answer that does not save.</param>
    /// <returns>True: save them; false: there are none, or they need not be kept; null: the drawing stays open.</returns>
    private async Task<bool?> AskAboutEditsAsync(string question, string without)
    {
        if (!_desk.Session.Document.IsEdited) return false;
        var answer = await Question.AskAsync(Text.Get(question, Path.GetFileName(_desk.Session.Document.FilePath)), "Files.SaveFirst", without, "Files.CancelQuestion");
        return answer is null or "Files.CancelQuestion" ? null : answer == "Files.SaveFirst";
    }
}
