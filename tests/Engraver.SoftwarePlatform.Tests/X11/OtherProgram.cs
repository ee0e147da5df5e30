using System.Text;
using Engraver.SoftwarePlatform.X11.Protocol;
using Engraver.SoftwarePlatform.X11.Selections;

namespace Engraver.SoftwarePlatform.Tests.X11;

/// <summary>Another program on the same server, as seen through the protocol: asks windows to close, and drags files.</summary>
internal sealed unsafe class OtherProgram : IDisposable
{
    private readonly XConnection _connection;
    private readonly XAtoms _atoms;
    private readonly nint _window;

    public OtherProgram(XServer server)
    {
        _connection = XConnection.Open(server.Display);
        _atoms = new XAtoms(_connection.Display);
        XSetWindowAttributes none;
        _window = Xlib.XCreateWindow(_connection.Display, _connection.Root, 0, 0, 1, 1, 0, 0, 0, 0, 0, &none);
    }

    public void AskToClose(nint window)
    {
        _connection.SendMessage(_connection.Root, window, Xlib.XInternAtom(_connection.Display, "_NET_CLOSE_WINDOW", 0), XEventMask.ToWindowManager, 0, 1);
        _connection.Flush();
    }

    /// <summary>Drags to a position and drops there. True if the window accepted the files.</summary>
    public bool Drop(nint onto, int rootX, int rootY, string uriList)
    {
        Xlib.XSetSelectionOwner(_connection.Display, _atoms.XdndSelection, _window, 0);
        _connection.SendMessage(onto, onto, _atoms.XdndEnter, 0, _window, XdndTarget.Version << 24, _atoms.UriList, 0, 0);
        _connection.SendMessage(onto, onto, _atoms.XdndPosition, 0, _window, 0, (rootX << 16) | rootY, 0, _atoms.XdndActionCopy);
        AnswerRequest(uriList);
        var status = WaitFor(XEventType.ClientMessage);
        Assert.Equal(_atoms.XdndStatus, status.MessageType);
        Assert.Equal(1, status.Data[1] & 1);
        _connection.SendMessage(onto, onto, _atoms.XdndDrop, 0, _window, 0, 0);
        var finished = WaitFor(XEventType.ClientMessage);
        Assert.Equal(_atoms.XdndFinished, finished.MessageType);
        return (finished.Data[1] & 1) == 1;
    }

    /// <summary>Waits until a started program has taken the clipboard: this program owns it first, and the server reports the loss.</summary>
    /// <remarks>xclip ends its first process before the second one owns the clipboard, so that the end of that process cannot be used.</remarks>
    public void GiveClipboardTo(Action program)
    {
        Xlib.XSetSelectionOwner(_connection.Display, _atoms.Clipboard, _window, 0);
        _connection.Sync();
        program();
        WaitFor(XEventType.SelectionClear);
    }

    public void Dispose() => _connection.Close();

    private void AnswerRequest(string uriList)
    {
        var request = WaitFor(XEventType.SelectionRequest);
        _connection.SetBytes(request.Requestor, request.RequestProperty, request.RequestTarget, Encoding.UTF8.GetBytes(uriList));
        var notice = new XEvent
        {
            Type = XEventType.SelectionNotify, Window = request.Requestor, Selection = request.RequestSelection, Target = request.RequestTarget,
            AnswerProperty = request.RequestProperty, AnswerTime = request.RequestTime,
        };
        Xlib.XSendEvent(_connection.Display, request.Requestor, 0, 0, &notice);
    }

    /// <summary>Fails, and does not hang, if no event arrives.</summary>
    private XEvent WaitFor(XEventType type)
    {
        const int patienceMs = 30_000;
        while (true)
        {
            while (Xlib.XPending(_connection.Display) > 0)
            {
                XEvent received;
                Xlib.XNextEvent(_connection.Display, &received);
                if (received.Type == type) return received;
            }

            var watched = new Libc.PollFd { Descriptor = Xlib.XConnectionNumber(_connection.Display), Events = Libc.PollIn };
            Assert.True(Libc.poll(&watched, 1, patienceMs) == 1, $"{type} never came.");
        }
    }
}
