using Avalonia.Controls;
using Avalonia.Input;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.Commands;

namespace Engraver.App.FileDialogs;

/// <summary>Files that are dragged onto the window from another program: a drawing is opened, a script is run, and an open file dialog takes any
/// file.</summary>
internal sealed class FileDrop
{
    private readonly DesktopModel _desk;
    private readonly FileQuestions _files;

    public FileDrop(Window window, DesktopModel desk, FileQuestions files)
    {
        (_desk, _files) = (desk, files);
        DragDrop.SetAllowDrop(window, true);
        DragDrop.AddDragOverHandler(window, OnOver);
        DragDrop.AddDropHandler(window, OnDrop);
    }

    private static string[] PathsOf(DragEventArgs e) => [.. (e.DataTransfer.TryGetFiles() ?? []).Select(file => file.Path).Where(address => address.IsFile).Select(address => address.LocalPath)];

    private static bool IsDrawing(string path) => path.EndsWith(".dxf", StringComparison.OrdinalIgnoreCase);

    private static bool IsScript(string path) => path.EndsWith(".scr", StringComparison.OrdinalIgnoreCase);

    private bool Accepts(string path) => _files.Dialog.IsOpen || IsDrawing(path) || IsScript(path);

    private void OnOver(object? sender, DragEventArgs e)
    {
        e.DragEffects = !_files.Question.IsOpen && PathsOf(e).Any(Accepts) ? DragDropEffects.Copy : DragDropEffects.None;
        e.Handled = true;
    }

    private void OnDrop(object? sender, DragEventArgs e)
    {
        OnOver(sender, e);
        if (e.DragEffects == DragDropEffects.None) return;
        var paths = PathsOf(e).Where(Accepts).ToList();
        if (_files.Dialog.IsOpen) _files.Dialog.TakeDropped(paths[0]);
        else OpenDropped(paths);
    }

    private void OpenDropped(List<string> paths)
    {
        var path = paths.FirstOrDefault(IsDrawing) ?? paths[0];
        if (_desk.Queue.IsBusy)
        {
            _desk.Notifications.Write(MessageKind.Warning, Text.Get("Files.DropWhileBusy", Path.GetFileName(path)));
            return;
        }

        if (paths.Count > 1) _desk.Notifications.Write(MessageKind.Note, Text.Get("Files.DropOneOnly", Path.GetFileName(path)));
        _ = IsDrawing(path) ? _files.OpenAsync(path) : _files.RunScriptAsync(path);
    }
}
