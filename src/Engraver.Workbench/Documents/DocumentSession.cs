using Engraver.Core.Drawings;
using Engraver.Workbench.Files;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>The open drawing with its edits and settings, and every step that led there. One of the two objects that change over time (the other is the
/// machine session); the states themselves never do.</summary>
/// <remarks>Selecting is no step: it goes with the state in which it was made. Steps come from one thread at a time; a selection may come from another
/// meanwhile.</remarks>
public sealed class DocumentSession
{
    private readonly Lock _guard = new();
    private readonly Stack<Step> _undo = new();
    private readonly Stack<Step> _redo = new();
    private readonly Dictionary<string, string> _sidecars = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _saved = new(StringComparer.Ordinal);
    private readonly Dictionary<string, IReadOnlyDictionary<string, IReadOnlyList<string>>> _handles = new(StringComparer.Ordinal);
    private Drawing? _kept;
    private Sidecar _keptSidecar = Sidecar.Empty;
    private int _begun;

    /// <summary>Raised after the current state has become another one.</summary>
    public event EventHandler? Changed;

    public DocumentState Current { get; private set; } = DocumentState.Nothing;

    /// <summary>The drawing, or what belongs to it, is another edition than was opened or written last: leaving the program would lose it.</summary>
    public bool IsEdited => IsDrawingEdited || (Current.Edition is not null && !Current.Sidecar.IsKeptBy(_keptSidecar));

    /// <summary>The drawing itself is another edition.</summary>
    public bool IsDrawingEdited => Current.Edition is { } edition && !ReferenceEquals(edition, _kept);

    /// <summary>Names of the steps that can be undone, the last one first.</summary>
    public IEnumerable<string> UndoNames => _undo.Select(step => step.Name);

    /// <summary>Names of the steps that can be redone, the next one first.</summary>
    public IEnumerable<string> RedoNames => _redo.Select(step => step.Name);

    /// <summary>Takes a step. What had been undone before it can no longer be redone.</summary>
    /// <param name="name">The command that takes it.</param>
    public void Take(string name, DocumentState next)
    {
        ArgumentNullException.ThrowIfNull(next);
        lock (_guard)
        {
            if (next == Current) return;
            _undo.Push(new Step(name, Current));
            _redo.Clear();
            Current = next;
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Joins the last step to the one before it, so that one undoing takes both back: a command that goes on is one step.</summary>
    public void JoinLastSteps()
    {
        if (_undo.Count > 1) _undo.Pop();
    }

    /// <summary>A drawing as it was read; its columns are those that a step of this session already keeps, where they say the same.</summary>
    public Drawing Shared(Drawing read)
    {
        ArgumentNullException.ThrowIfNull(read);
        foreach (var kept in _undo.Select(step => step.State.Edition).Prepend(Current.Edition).OfType<Drawing>().Distinct(ReferenceEqualityComparer.Instance).Cast<Drawing>())
        {
            if (read.SharingColumnsOf(kept) is var shared && ReferenceEquals(shared.Parts, kept.Parts)) return shared;
        }

        return read;
    }

    /// <summary>Puts another state in the place of the current one, within the last step: undoing goes back behind both.</summary>
    public void Amend(DocumentState next)
    {
        ArgumentNullException.ThrowIfNull(next);
        lock (_guard)
        {
            if (next == Current) return;
            Current = next;
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Path of the file that the drawing belongs to: the one that was written last, else the one that was opened; null when no drawing is
    /// open.</summary>
    public string? FilePath => Current.Drawing is { FileName: var opened } ? _saved.GetValueOrDefault(opened, opened) : null;

    /// <summary>The drawing was opened from a file or has been saved in one.</summary>
    public bool HasFile => Current.Drawing is { } drawing && (!drawing.IsNew || _saved.ContainsKey(drawing.FileName));

    /// <summary>The number of the drawing that is begun now: 1 for the first one of the session.</summary>
    public int CountBegun() => ++_begun;

    /// <summary>Notes that the drawing as it is now, and what belongs to it, stand in the file that was opened; or that nothing of a new one is worth
    /// saving.</summary>
    public void MarkOpened()
    {
        if (Current.Drawing is { FileName: var opened })
        {
            _saved.Remove(opened);
            _handles.Remove(Path.GetFullPath(opened));
        }

        (_kept, _keptSidecar) = (Current.Edition, Current.Sidecar);
    }

    /// <summary>Notes that the drawing as it is now, and what belongs to it, were written.</summary>
    /// <param name="path">Of the drawing, which belongs to this file from now on, unless it is a stream.</param>
    public void MarkSaved(string path)
    {
        if (Current.Drawing is { FileName: var opened } drawing && !FileKind.IsStream(path))
        {
            _saved[opened] = path;
            if (drawing.IsNew) Current = Current with { Drawing = drawing with { FileName = path, IsNew = false } };
        }

        (_kept, _keptSidecar) = (Current.Edition, Current.Sidecar);
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>The text of a sidecar file as this session read or wrote it last; null when it did neither.</summary>
    /// <param name="path">Of the sidecar.</param>
    public string? KnownSidecar(string path) => _sidecars.GetValueOrDefault(Path.GetFullPath(path));

    /// <summary>For each handle of the drawing those of its entities in a file that this session wrote; empty where they are the same, as in the file that
    /// was opened.</summary>
    /// <param name="path">Of the drawing's file.</param>
    public IReadOnlyDictionary<string, IReadOnlyList<string>> HandlesIn(string path) => _handles.GetValueOrDefault(Path.GetFullPath(path)) ?? new Dictionary<string, IReadOnlyList<string>>();

    /// <summary>Notes under which handles the entities of the drawing stand in a file.</summary>
    public void MarkHandles(string path, IReadOnlyDictionary<string, IReadOnlyList<string>> handles) => _handles[Path.GetFullPath(path)] = handles;

    /// <summary>Notes what stands in a sidecar file now.</summary>
    public void MarkSidecar(string path, string text) => _sidecars[Path.GetFullPath(path)] = text;

    /// <summary>Sets what is selected, without a step.</summary>
    public void Select(IReadOnlyList<int> selection, IReadOnlyList<int> previous)
    {
        lock (_guard) Current = Current with { Selection = selection, Previous = previous };
        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Changes what is selected in a drawing, unless another one stands there meanwhile.</summary>
    /// <param name="next">Gives the new selection from the present state.</param>
    public void SelectIn(Drawing drawing, Func<DocumentState, IReadOnlyList<int>> next)
    {
        ArgumentNullException.ThrowIfNull(next);
        lock (_guard)
        {
            if (!ReferenceEquals(Current.Drawing, drawing)) return;
            Current = Current with { Selection = next(Current) };
        }

        Changed?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Goes back to the state before the last step. While a drawing is open, undoing never closes it: the opening of the first drawing cannot be
    /// undone, and one that was opened after another
    /// was closed is replaced by that one.</summary>
    /// <returns>The name of the step, null when there was none.</returns>
    public string? Undo()
    {
        var open = Current.Drawing is not null;
        if (open && !_undo.Any(step => step.State.Drawing is not null)) return null;
        var name = Swap(_undo, _redo);
        while (open && Current.Drawing is null) Swap(_undo, _redo);
        return name;
    }

    /// <summary>Takes the step again that was undone last.</summary>
    /// <returns>The name of the step, null when there was none.</returns>
    public string? Redo() => Swap(_redo, _undo);

    private string? Swap(Stack<Step> from, Stack<Step> to)
    {
        string name;
        lock (_guard)
        {
            if (!from.TryPop(out var step)) return null;
            to.Push(step with { State = Current });
            (name, Current) = (step.Name, step.State);
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return name;
    }

    private readonly record struct Step(string Name, DocumentState State);
}
