using System.Windows.Input;
using Avalonia.Media;

namespace Engraver.App.Shell;

/// <summary>A button of the tool column.</summary>
/// <param name="Command">The command it runs.</param>
/// <param name="EndsGroup">True: a separator follows.</param>
public sealed record ToolButton(string Command, Geometry Icon, string Tip, ICommand RunCommand, bool EndsGroup);
