namespace Engraver.App.Binding;

/// <summary>A control that, while it has the focus, uses the arrow keys and Home, which otherwise go to the command line.</summary>
public interface IArrowKeyTarget;
