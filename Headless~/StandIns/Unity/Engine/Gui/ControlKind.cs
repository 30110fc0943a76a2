namespace StandIns;

/// <summary>Kind of a control of a drawn inspector.</summary>
[Unity.StandIns.StandInExtension]
public enum ControlKind
{
    Field,
    Label,
    Button,
    Toggle,
    Foldout,
    HelpBox,
    Area,
}
