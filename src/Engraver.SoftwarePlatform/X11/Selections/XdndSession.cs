using Avalonia.Input.Raw;

namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Files dragged over a window, by the XDND protocol, version 5: from Enter over Positions to Leave or Drop.</summary>
/// <remarks>The source waits for a status after each position, so that the status of the first position is delayed until the files are known.</remarks>
internal sealed class XdndSession(IXdndPartner partner)
{
    private nint _source;
    private IReadOnlyList<string> _files = [];
    private Stage _stage;
    private bool _statusDue;
    private bool _dropDue;
    private int _x;
    private int _y;

    private enum Stage
    {
        Outside,
        Refused,
        Unknown,
        Asked,
        Inside,
    }

    public void Enter(nint source, bool offersFiles)
    {
        Leave();
        _source = source;
        _stage = offersFiles ? Stage.Unknown : Stage.Refused;
    }

    public void Position(nint source, int rootX, int rootY, nint time)
    {
        if (source != _source || _stage == Stage.Outside) return;
        (_x, _y) = (rootX, rootY);
        if (_stage == Stage.Refused) partner.SendStatus(_source, false);
        else if (_stage == Stage.Inside) partner.SendToWindow(RawDragEventType.DragOver, _x, _y, _files);
        else RequestFilesFirst(time, ref _statusDue);
    }

    public void Drop(nint source, nint time)
    {
        if (source != _source || _stage == Stage.Outside) return;
        if (_stage == Stage.Refused) Finish(false);
        else if (_stage == Stage.Inside) partner.SendToWindow(RawDragEventType.Drop, _x, _y, _files);
        else RequestFilesFirst(time, ref _dropDue);
    }

    public void Leave()
    {
        if (_stage == Stage.Inside) partner.SendToWindow(RawDragEventType.DragLeave, _x, _y, _files);
        Forget();
    }

    /// <summary>Null or empty when the source provided none.</summary>
    public void FilesArrived(IReadOnlyList<string>? files)
    {
        if (_stage != Stage.Asked) return;
        _files = files ?? [];
        if (_files.Count == 0) RefuseAll();
        else EnterWindow();
    }

    /// <summary>The window's reply to an event that was sent to it.</summary>
    public void Answer(RawDragEventType to, bool accepted)
    {
        if (_stage != Stage.Inside) return;
        if (to == RawDragEventType.DragOver) partner.SendStatus(_source, accepted);
        if (to == RawDragEventType.Drop) Finish(accepted);
    }

    private void RequestFilesFirst(nint time, ref bool due)
    {
        due = true;
        if (_stage == Stage.Asked) return;
        _stage = Stage.Asked;
        partner.RequestFiles(time);
    }

    private void EnterWindow()
    {
        _stage = Stage.Inside;
        partner.SendToWindow(RawDragEventType.DragEnter, _x, _y, _files);
        if (_statusDue) partner.SendToWindow(RawDragEventType.DragOver, _x, _y, _files);
        if (_dropDue) partner.SendToWindow(RawDragEventType.Drop, _x, _y, _files);
        (_statusDue, _dropDue) = (false, false);
    }

    private void RefuseAll()
    {
        _stage = Stage.Refused;
        if (_statusDue) partner.SendStatus(_source, false);
        if (_dropDue) Finish(false);
    }

    private void Finish(bool accepted)
    {
        partner.SendFinished(_source, accepted);
        Forget();
    }

    private void Forget()
    {
        (_source, _files, _stage, _statusDue, _dropDue) = (0, [], Stage.Outside, false, false);
    }
}
