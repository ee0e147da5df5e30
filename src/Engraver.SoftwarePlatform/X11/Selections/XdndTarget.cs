using System.Text;
using Avalonia;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>The protocol's messages, to and from the session, on the event thread.</summary>
internal sealed class XdndTarget : IXdndPartner
{
    public const int Version = 5;
    private readonly XConnection _connection;
    private readonly X11Desktop _desktop;
    private readonly SelectionReader _reader;
    private readonly XdndSession _session;
    private X11WindowEvents? _window;

    public XdndTarget(XConnection connection, X11Desktop desktop, SelectionReader reader)
    {
        _connection = connection;
        _desktop = desktop;
        _reader = reader;
        _session = new XdndSession(this);
    }

    private XAtoms Atoms => _desktop.Atoms;

    /// <returns>False when the message is not about dragging.</returns>
    public unsafe bool Handle(X11WindowEvents window, ref XEvent message)
    {
        var source = (nint)message.Data[0];
        if (message.MessageType == Atoms.XdndEnter)
        {
            _session.Leave();
            _window = window;
            _session.Enter(source, OffersFiles(ref message));
        }
        else if (message.MessageType == Atoms.XdndPosition)
        {
            _session.Position(source, (short)(message.Data[2] >> 16), (short)message.Data[2], (nint)message.Data[3]);
        }
        else if (message.MessageType == Atoms.XdndLeave) _session.Leave();
        else if (message.MessageType == Atoms.XdndDrop) _session.Drop(source, (nint)message.Data[2]);
        else return false;
        return true;
    }

    public void RequestFiles(nint time) =>
        _reader.Request(Atoms.UriList, time, bytes => _session.FilesArrived(bytes is null ? null : UriList.LocalPaths(Encoding.UTF8.GetString(bytes))));

    public void SendToWindow(RawDragEventType type, int rootX, int rootY, IReadOnlyList<string> files) =>
        _window?.OnDrag(type, new PixelPoint(rootX, rootY), files, effects => _desktop.Events.Post(() => _session.Answer(type, effects != DragDropEffects.None)));

    public void SendStatus(nint source, bool accepted)
    {
        const int wantsEveryPosition = 2;
        _connection.SendMessage(source, source, Atoms.XdndStatus, 0, _window?.Handle ?? 0, wantsEveryPosition | (accepted ? 1 : 0), 0, 0, accepted ? Atoms.XdndActionCopy : XAtoms.None);
    }

    public void SendFinished(nint source, bool accepted) =>
        _connection.SendMessage(source, source, Atoms.XdndFinished, 0, _window?.Handle ?? 0, accepted ? 1 : 0, accepted ? Atoms.XdndActionCopy : XAtoms.None);

    /// <summary>The types of the data: up to three are in the message, more in a property of the source.</summary>
    private unsafe bool OffersFiles(ref XEvent enter)
    {
        if ((enter.Data[1] & 1) != 0) return _connection.GetLongs((nint)enter.Data[0], Atoms.XdndTypeList).Contains(Atoms.UriList);
        return enter.Data[2] == Atoms.UriList || enter.Data[3] == Atoms.UriList || enter.Data[4] == Atoms.UriList;
    }
}
