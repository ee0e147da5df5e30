using System.Text;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>Sets a window's properties for the window manager and sends it requests (ICCCM and EWMH), over the drawing connection.</summary>
internal sealed class WindowProperties(X11Desktop desktop, nint window)
{
    private readonly List<nint> _firstStates = [];

    public SizeHints Hints { get; } = new();

    /// <summary>True while a window manager runs (EWMH).</summary>
    public bool IsManaged => Connection.GetLongs(Connection.Root, Atoms.NetSupportingWmCheck).Length > 0;

    private XConnection Connection => desktop.Drawing;

    private XAtoms Atoms => desktop.Atoms;

    /// <summary>Called once, before the window is shown.</summary>
    public void Introduce()
    {
        const int inputHint = 1;
        var name = desktop.ApplicationName;
        Connection.SetLongs(window, Atoms.WmProtocols, XAtoms.Atom, Atoms.WmDeleteWindow, Atoms.NetWmPing);
        Connection.SetLongs(window, XAtoms.WmHints, XAtoms.WmHints, inputHint, 1, 0, 0, 0, 0, 0, 0, 0);
        Connection.SetText(window, XAtoms.WmClass, XAtoms.String, $"{name}\0{name}\0");
        Connection.SetLongs(window, Atoms.NetWmPid, XAtoms.Cardinal, Environment.ProcessId);
        Connection.SetText(window, Atoms.WmClientMachine, XAtoms.String, Environment.MachineName);
    }

    public void SetTitle(string title)
    {
        Connection.SetText(window, Atoms.NetWmName, Atoms.Utf8String, title);
        Connection.SetBytes(window, XAtoms.WmName, XAtoms.String, Encoding.Latin1.GetBytes(title)); // for old window managers
        Connection.Flush();
    }

    public void SetIcon(IconPicture? picture)
    {
        if (picture is null) Xlib.XDeleteProperty(Connection.Display, window, Atoms.NetWmIcon);
        else Connection.SetLongs(window, Atoms.NetWmIcon, XAtoms.Cardinal, NetWmIcon.Pack(picture));
        Connection.Flush();
    }

    public void SetType(bool isDialog) =>
        Connection.SetLongs(window, Atoms.NetWmWindowType, XAtoms.Atom, isDialog ? Atoms.NetWmWindowTypeDialog : Atoms.NetWmWindowTypeNormal);

    /// <summary>Motif's hint for windows with or without decorations, which every window manager still supports.</summary>
    public void SetDecorations(bool wanted)
    {
        const int decorationsHint = 2;
        Connection.SetLongs(window, Atoms.MotifWmHints, Atoms.MotifWmHints, decorationsHint, 0, wanted ? 1 : 0, 0, 0);
    }

    public void SendHints() => Connection.SetLongs(window, XAtoms.WmNormalHints, XAtoms.WmSizeHints, Hints.Pack());

    /// <summary>Before the window is shown its states are a property that the window manager reads; afterwards they are requested by messages.</summary>
    public void ChangeState(bool shown, bool wanted, nint state, nint second = 0)
    {
        const nint fromApplication = 1;
        if (shown)
        {
            Connection.SendMessage(Connection.Root, window, Atoms.NetWmState, XEventMask.ToWindowManager, wanted ? 1 : 0, state, second, fromApplication);
            return;
        }

        foreach (var each in new[] { state, second }.Where(each => each != 0))
        {
            _firstStates.Remove(each);
            if (wanted) _firstStates.Add(each);
        }

        Connection.SetLongs(window, Atoms.NetWmState, XAtoms.Atom, [.. _firstStates]);
    }

    /// <summary>Requests the focus from the window manager; without a window manager, takes it.</summary>
    public void RequestFocus()
    {
        const nint fromApplication = 1;
        const int toParent = 2;
        if (IsManaged)
            Connection.SendMessage(Connection.Root, window, Atoms.NetActiveWindow, XEventMask.ToWindowManager, fromApplication, 0, 0);
        else Xlib.XSetInputFocus(Connection.Display, window, toParent, 0);
    }
}
